// The disc's look: its image or texture, filtered by the footprint, and how much of the pixel it covers.

#ifdef EFFECT_DISC_IMAGE
vec4 disc_texel(vec2 place, float level) {
    vec2 turned = vec2(frame.disc_map.x * place.x + frame.disc_map.y * place.y,
                       frame.disc_map.x * place.y - frame.disc_map.y * place.x);
    return textureLod(disc_texture, vec2(0.5 + turned.x, 0.5 - turned.y), level);
}
#endif

#ifdef EFFECT_DISC_IMAGE
// The image, filtered by the footprint's sides a and b.
vec4 disc_filtered(vec2 middle, vec2 a, vec2 b) {
    float texels = frame.disc_map.z;
    float aa = dot(a, a);
    float bb = dot(b, b);
    vec2 wide = aa > bb ? a : b;
    float longer2 = max(aa, bb) * texels * texels;                     // sides of the footprint in texels, squared
    float area = abs(a.x * b.y - a.y * b.x) * texels * texels;
    // One tap, or two along the longer side of a footprint that is long and more than one texel wide.
    bool two = longer2 > 2.0 && longer2 > 2.25 * area;
    float side2 = two ? max(0.25 * longer2, area) : longer2;
    float level = footprint_level(0.5 * log2(max(side2, 1.0e-12)), frame.disc_map.w);
    vec2 step = two ? 0.5 * wide : vec2(0.0);
    vec2 place = middle - 0.5 * step;
    vec4 texel = vec4(0.0);
    int left = two ? 2 : 1;
    do {   // tested at the end: software rasterisers run a loop's body once more than a test at its head lets through
        texel += disc_texel(place, level);
        place += step;
    } while (--left > 0);
    return texel * (two ? 0.5 : 1.0);
}
#endif

#ifdef EFFECT_DISC_PATTERN
vec3 disc_coat_paint(vec3 at, vec3 along, vec3 across);   // object/paint.glsl
#endif

// Of image or texture at a place, with the pixel's sides a and b there.
vec4 disc_cover(vec2 place, vec2 a, vec2 b) {
#ifdef EFFECT_DISC_IMAGE
    return disc_filtered(place, a, b);
#endif
#ifdef EFFECT_DISC_PATTERN
    return vec4(disc_coat_paint(vec3(place, 0.0), vec3(a, 0.0), vec3(b, 0.0)), 1.0);
#endif
    return vec4(1.0);
}

#ifdef EFFECT_DISC_FLOW
vec4 disc_flow(DiscCrossing crossing, float late);   // object/disc_flow.glsl
#endif
#ifdef EFFECT_SPOT
vec3 spot_light(Trace trace, DiscCrossing crossing, float late);   // object/spot.glsl
#endif

// Premultiplied colour and coverage.
vec4 disc_colour(Trace trace, DiscCrossing crossing) {
    vec2 a = crossing.along;
    vec2 b = crossing.across;
#ifdef NEEDS_LATE
    float late = 0.0;
#ifdef EFFECT_DELAY
#ifdef EFFECT_SPIN
    late = crossing.late;
#else
    late = light_time(trace, crossing.phi, crossing.r, crossing.zeta_slope);
#endif
#endif
#endif
#ifdef EFFECT_DISC_FLOW
    vec4 texel = disc_flow(crossing, late);
#else
    vec4 texel = disc_cover(crossing.place, a, b);
#endif
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec2 outward = crossing.place / crossing.r;
    float across = clamp(abs(dot(a, outward)) + abs(dot(b, outward)), 1.0e-6, 0.25 * (outer - inner));   // pixel's extent in r
    float alpha = clamp((crossing.r - inner) / across + 0.5, 0.0, 1.0) * clamp((outer - crossing.r) / across + 0.5, 0.0, 1.0);
#ifdef EFFECT_SPOT
    vec3 spot = spot_light(trace, crossing, late) * alpha;
#endif
    alpha *= texel.a;
#ifdef EFFECT_TRANSLUCENT_DISC
    float depth = min(crossing.r - inner, outer - crossing.r) / (outer - inner);
    float fade = frame.disc_look.y;
    float t = clamp(depth / max(fade, 1.0e-6), 0.0, 1.0);
    alpha *= frame.disc_look.x * (fade > 0.0 ? t * t * (3.0 - 2.0 * t) : 1.0);
#endif
    vec3 light = texel.rgb * frame.disc_look.z;
#ifdef EFFECT_THERMAL_DISC
    light *= thermal_light(disc_matter(trace, crossing));
#endif
#ifdef EFFECT_SPOT
    return vec4(light * alpha + spot, alpha);
#else
    return vec4(light, 1.0) * alpha;
#endif
}
