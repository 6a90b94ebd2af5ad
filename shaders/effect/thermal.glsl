// What the heat of the disc looks like from here, linear light: a black body of temperature T seen with its frequencies times g is
// one of gT (light/black_body.h). Without EFFECT_SHIFT the colour stays as it left, without EFFECT_BEAMING the brightness does.
vec3 thermal_light(DiscFlow flow) {
    float temperature = frame.disc_heat.z + flow.heat;
    float hue = temperature;
    float glow = temperature;
#ifdef EFFECT_SHIFT
    float colour_shift = log2(flow.g);
    hue += colour_shift;
#endif
#ifdef EFFECT_BEAMING
    float beaming = log2(flow.g);
    glow += beaming;
#endif
    return black_body(hue, glow, frame.disc_heat.w);
}
