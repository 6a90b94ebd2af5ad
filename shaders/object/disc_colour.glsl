// The disc's look: its light, and how much of the pixel it covers.
#include "object/disc_cover.glsl"
#include "path/disc"
#ifdef EFFECT_DISC_FLOW
#include "object/disc_flow.glsl"
#endif
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif
#ifdef EFFECT_SPOT
#include "object/spot.glsl"
#endif
#include "path/trace"
#include "shared/frame.glsl"

// Premultiplied colour and coverage.
vec4 disc_colour(Trace trace, DiscCrossing crossing) {
    vec2 a = crossing.along;
    vec2 b = crossing.across;
#ifdef NEEDS_LATE
    float late = 0.0;
#ifdef EFFECT_DELAY
    late = disc_late(trace, crossing);
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
