// The light of one body: this text is written once for each of a scene's bodies, with BODY its name. At the hit: where on the
// body, how a pixel lies there, the texture averaged over it.
#ifdef TEXTURE_IMAGE
vec3 BODY_image(vec2 uv, vec2 a, vec2 b) {
    vec2 texels = vec2(textureSize(BODY_texture, 0));
    vec2 wide = a * texels;
    vec2 high = b * texels;
    float aa = dot(wide, wide);
    float bb = dot(high, high);
    float side2 = max(0.36 * max(aa, bb), abs(wide.x * high.y - wide.y * high.x));
    float level = footprint_level(0.5 * log2(max(side2, 1.0e-12)), 16.0);
    return textureLod(BODY_texture, uv, level).rgb;
}
#endif
#ifdef TEXTURE_FORMULA
float BODY_blend(vec2 uv, vec3 at) {
    float u = uv.x;
    float v = uv.y;
    float x = at.x;
    float y = at.y;
    float z = at.z;
BODY_STATEMENTS
    return clamp(value, 0.0, 1.0);
}
#endif

vec2 BODY_uv(vec3 at) {
#ifdef MAPPING_PLANE
    vec3 turned = mapping_turned(at, frame.BODY_map.xy) * (0.5 / frame.BODY_form.y);
    return vec2(0.5 + turned.x, 0.5 - turned.y);
#endif
#ifdef MAPPING_EQUIRECTANGULAR
    return mapping_equirectangular(mapping_turned(at, frame.BODY_map.xy));
#endif
#ifdef MAPPING_BAND
    return mapping_band(mapping_turned(at, frame.BODY_map.xy), frame.BODY_second.w);
#endif
#ifdef MAPPING_CAPS
    return mapping_caps(mapping_turned(at, frame.BODY_map.xy));
#endif
#ifdef MAPPING_CUBE
    return mapping_cube(mapping_turned(at, frame.BODY_map.xy));
#endif
}

// at: about the body's middle.
vec3 BODY_light(Trace trace, RayPlace place, vec3 at, vec3 normal) {
    SolidSpot spot = solid_spot(trace, place, normal);
    vec3 first = frame.BODY_colour.rgb;
    vec3 second = frame.BODY_second.rgb;
    vec2 uv = BODY_uv(at);
    vec2 a = mapping_step(BODY_uv(at + spot.along), uv);
    vec2 b = mapping_step(BODY_uv(at + spot.across), uv);
    vec2 cells = frame.BODY_map.zw;
    vec2 wide = (abs(a) + abs(b)) * cells;
    vec3 light = first;
#ifdef TEXTURE_CHECKER
    light = mix(second, first, pattern_checker(uv * cells, wide));
#endif
#ifdef TEXTURE_GRID
    light = mix(second, first, pattern_grid(uv * cells, wide));
#endif
#ifdef TEXTURE_STRIPES
    light = mix(second, first, pattern_stripes(uv * cells, wide));
#endif
#ifdef TEXTURE_NOISE
    float grains = cells.x / frame.BODY_size;
    vec3 grain = mapping_turned(at, frame.BODY_map.xy) * grains;
    light = mix(second, first, grain_noise(grain, grains * max(length(spot.along), length(spot.across))));
#endif
#ifdef TEXTURE_FORMULA
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {   // four places of the pixel's box
        vec2 corner = vec2((i & 1) == 0 ? -0.25 : 0.25, i < 2 ? -0.25 : 0.25);
        sum += BODY_blend(uv + corner.x * a + corner.y * b, at + corner.x * spot.along + corner.y * spot.across);
    }
    light = mix(second, first, 0.25 * sum);
#endif
#ifdef TEXTURE_IMAGE
    light = first * BODY_image(uv, a, b);
#endif
#ifdef MAPPING_BAND
    light = mix(light, second, clamp((abs(uv.y - 0.5) - 0.5) / max(abs(a.y) + abs(b.y), 1.0e-6) + 0.5, 0.0, 1.0));
#endif
    return light * solid_limb(frame.BODY_colour.w, spot.cosine);
}
