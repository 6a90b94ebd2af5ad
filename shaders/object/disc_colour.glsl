// The disc: its light, and how much of the pixel it covers.
#include "object/disc_cover.glsl"
#include "path/disc"
#ifdef EFFECT_DISC_FLOW
#include "object/disc_flow.glsl"
#endif
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif
#ifdef SLOT_DISC_GLOW
#include "generated/disc_glow"
#endif
#include "path/trace"
#include "shared/frame.glsl"

// Premultiplied colour and coverage.
vec4 disc_colour(Trace trace, DiscCrossing crossing) {
    vec2 a = crossing.along;
    vec2 b = crossing.across;
#ifdef NEEDS_DELAY
    float delay = 0.0;
#ifdef EFFECT_DELAY
    delay = disc_delay(trace, crossing);
#endif
#endif
#ifdef EFFECT_DISC_FLOW
    vec4 texel = disc_flow(crossing, delay);
#else
    vec4 texel = disc_cover(crossing.place, a, b);
#endif
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec2 outward = crossing.place / crossing.r;
    float across = clamp(abs(dot(a, outward)) + abs(dot(b, outward)), 1.0e-6, 0.25 * (outer - inner));   // pixel's extent in r
    float alpha = clamp((crossing.r - inner) / across + 0.5, 0.0, 1.0) * clamp((outer - crossing.r) / across + 0.5, 0.0, 1.0);
#ifdef SLOT_DISC_GLOW
    vec3 glow = disc_glow(trace, crossing, delay) * alpha;
#endif
    alpha *= texel.a;
#ifdef EFFECT_TRANSLUCENT_DISC
    float depth = min(crossing.r - inner, outer - crossing.r) / (outer - inner);
    float fade = frame.disc_surface.y;
    float t = clamp(depth / max(fade, 1.0e-6), 0.0, 1.0);
    alpha *= frame.disc_surface.x * (fade > 0.0 ? t * t * (3.0 - 2.0 * t) : 1.0);
#endif
    vec3 light = texel.rgb * frame.disc_surface.z;
#ifdef EFFECT_THERMAL_DISC
    light *= thermal_light(disc_matter(trace, crossing));
#endif
#ifdef SLOT_DISC_GLOW
    return vec4(light * alpha + glow, alpha);
#else
    return vec4(light, 1.0) * alpha;
#endif
}
