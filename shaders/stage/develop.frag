// From the picture in linear light to the display.
out vec4 colour;

void main() {
    vec3 light = texelFetch(picture_texture, ivec2(gl_FragCoord.xy), 0).rgb;
    float exposure = frame.image.w;
#ifdef EFFECT_BLOOM
    light = mix(light, textureLod(bloom_texture, gl_FragCoord.xy / frame.image.xy, 0.0).rgb, frame.bloom.x);
#endif
#ifdef EFFECT_AUTO_EXPOSURE
    float metered = texelFetch(meter_texture, ivec2(0), 0).r;
    exposure *= METER_KEY / clamp(metered, 1.0e-4, 1.0e4);
#endif
    colour = vec4(display_encode(light, exposure), 1.0);
}
