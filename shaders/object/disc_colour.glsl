// The disc's look: its image, filtered by the footprint, and how much of the pixel it covers.

vec4 disc_texel(vec2 place, float level) {
    vec2 turned = vec2(frame.disc_map.x * place.x + frame.disc_map.y * place.y,
                       frame.disc_map.x * place.y - frame.disc_map.y * place.x);
    return textureLod(disc_texture, vec2(0.5 + turned.x, 0.5 - turned.y), level);
}

// Premultiplied colour and coverage.
vec4 disc_colour(DiscCrossing crossing) {
    vec2 a = crossing.along;
    vec2 b = crossing.across;
    float texels = frame.disc_map.z;
    float la = length(a);
    float lb = length(b);
    vec2 wide = la > lb ? a : b;
    float longer = max(la, lb);
    float area = abs(a.x * b.y - a.y * b.x);
    float shorter = area / max(longer, 1.0e-12);
    Taps taps = footprint_taps(min(longer * texels, 1.0e5), shorter * texels, frame.disc_look.w, frame.disc_map.w);
    vec4 texel = vec4(0.0);
    for (int i = 0; i < taps.count; ++i) {
        float offset = (float(i) + 0.5) / float(taps.count) - 0.5;
        texel += disc_texel(crossing.place + offset * wide, taps.level);
    }
    texel /= float(taps.count);
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec2 outward = crossing.place / crossing.r;
    float across = clamp(abs(dot(a, outward)) + abs(dot(b, outward)), 1.0e-6, 0.25 * (outer - inner));   // pixel's extent in r
    float alpha = clamp((crossing.r - inner) / across + 0.5, 0.0, 1.0) * clamp((outer - crossing.r) / across + 0.5, 0.0, 1.0);
    alpha *= texel.a;
#ifdef EFFECT_TRANSLUCENT_DISC
    float depth = min(crossing.r - inner, outer - crossing.r) / (outer - inner);
    float fade = frame.disc_look.y;
    float t = clamp(depth / max(fade, 1.0e-6), 0.0, 1.0);
    alpha *= frame.disc_look.x * (fade > 0.0 ? t * t * (3.0 - 2.0 * t) : 1.0);
#endif
    return vec4(texel.rgb * frame.disc_look.z, 1.0) * alpha;
}
