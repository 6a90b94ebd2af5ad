// The rims of the disc, and whether a radius is on it.
#ifdef EFFECT_DISC_WARP
#include "object/disc_shape.glsl"
#endif
#include "shared/frame.glsl"

// By no more is the disc widened for rims that cover a pixel in part, r_s.
float disc_rim() { return 0.125 * min(frame.disc_y.w - frame.disc_x.w, frame.disc_x.w); }

#ifdef EFFECT_DISC_WARP
bool disc_has(float r, float reach) { return disc_warp_at(r).at.w * r >= -reach; }
// Part of a pixel that reaches over `across` in r.
float disc_covered(float r, float across) { return clamp(disc_warp_at(r).at.w * r / across + 0.5, 0.0, 1.0); }
// How far from the nearest end of its ring.
float disc_depth(float r) {
    DiscWarpPlace place = disc_warp_at(r);
    return r * (place.slope.w > 0.0 ? 1.0 - exp(-place.at.w) : exp(place.at.w) - 1.0);
}
#else
bool disc_has(float r, float reach) { return r >= frame.disc_x.w - reach && r <= frame.disc_y.w + reach; }
float disc_covered(float r, float across) {
    return clamp((r - frame.disc_x.w) / across + 0.5, 0.0, 1.0) * clamp((frame.disc_y.w - r) / across + 0.5, 0.0, 1.0);
}
float disc_depth(float r) { return min(r - frame.disc_x.w, frame.disc_y.w - r); }
#endif

#ifdef EFFECT_TRANSLUCENT_DISC
// Of its opacity, so far from its rims.
float disc_whole(float depth) {
    float fade = frame.disc_surface.y;
    float t = clamp(depth / (frame.disc_y.w - frame.disc_x.w) / max(fade, 1.0e-6), 0.0, 1.0);
    return fade > 0.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
}
#endif
