// Light of a black body by the logarithm of its temperature: black_body_texture holds (colour of unit luminance, log2 of the
// luminance) at equal steps of log2 T.

uniform highp sampler2D black_body_texture;
vec4 black_body_fetch(int i) { return texelFetch(black_body_texture, ivec2(i, 0), 0); }

#define PLANCK_CELLS 1024
#define PLANCK_COLDEST 9.0
#define PLANCK_PER_OCTAVE 102.4

// log2_hue: of the temperature (K) that gives the colour; log2_glow: of the one that gives the brightness, in which `scale` (log2)
// is taken off.
vec3 black_body(float log2_hue, float log2_glow, float scale) {
    float hue = clamp((log2_hue - PLANCK_COLDEST) * PLANCK_PER_OCTAVE, 0.0, float(PLANCK_CELLS) - 0.001);
    float at = (log2_glow - PLANCK_COLDEST) * PLANCK_PER_OCTAVE;
    float glow = clamp(at, 0.0, float(PLANCK_CELLS) - 0.001);
    int i = int(hue);
    int j = int(glow);
    vec4 h0 = black_body_fetch(i);
    vec4 h1 = black_body_fetch(i + 1);
    vec3 colour = h0.xyz + (hue - float(i)) * (h1.xyz - h0.xyz);
    colour = mix(vec3(1.0), colour, 1.0 / (1.0 - min(min(colour.x, colour.y), min(colour.z, 0.0))));   // into Rec. 709's gamut
    colour = max(colour, vec3(0.0));   // which rounding leaves
#ifdef EFFECT_BOLOMETRIC
    float all_wavelengths = 4.0 * log2_glow;
    float luminance = all_wavelengths;
#else
    if (at < 0.0) return vec3(0.0);
    float l0 = black_body_fetch(j).w;
    float l1 = black_body_fetch(j + 1).w;
    float luminance = l0 + (glow - float(j)) * (l1 - l0) + max(at - float(PLANCK_CELLS), 0.0) / PLANCK_PER_OCTAVE;
#endif
    return colour * exp2(min(luminance - scale, 60.0));
}

// A black body of temperature T seen with its frequencies times g is one of gT (light/black_body.h). Without EFFECT_SHIFT the colour
// stays as it left, without EFFECT_BEAMING the brightness does.
vec3 seen_black_body(float log2_temperature, float g, float scale) {
    float hue = log2_temperature;
    float glow = log2_temperature;
#ifdef EFFECT_SHIFT
    float colour_shift = log2(g);
    hue += colour_shift;
#endif
#ifdef EFFECT_BEAMING
    float beaming = log2(g);
    glow += beaming;
#endif
    return black_body(hue, glow, scale);
}
