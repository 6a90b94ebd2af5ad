// The disc: its light, and how much of the pixel it covers.
#include "path/disc"
#ifdef EFFECT_DISC_GAS
#include "object/disc_gas.glsl"
#else
#include "object/disc_cover.glsl"
#ifdef EFFECT_DISC_FLOW
#include "object/disc_flow.glsl"
#endif
#endif
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif
#include "object/disc_rim.glsl"
#include "object/disc_stokes.glsl"
#ifdef SLOT_DISC_GLOW
#include "generated/disc_glow"
#endif
#include "path/trace"
#include "shared/frame.glsl"

#ifndef EFFECT_DISC_GAS
vec4 disc_painted(DiscCrossing crossing, float delay) {
#ifdef EFFECT_DISC_FLOW
    return disc_flow(crossing, delay);
#else
    return disc_cover(crossing.place, crossing.along, crossing.across);
#endif
}
#endif

// Premultiplied colour and coverage.
vec4 disc_colour(Trace trace, DiscCrossing crossing) {
    disc_stokes_begin();
    float delay = 0.0;
#ifdef NEEDS_DELAY
#ifdef EFFECT_DELAY
    delay = disc_delay(trace, crossing);
#endif
#endif
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec2 outward = crossing.place / crossing.r;
    float across = clamp(abs(dot(crossing.along, outward)) + abs(dot(crossing.across, outward)), 1.0e-6, 0.25 * (outer - inner));   // pixel's extent in r
    float alpha = disc_covered(crossing.r, across);
#ifdef SLOT_DISC_GLOW
    vec3 glow = disc_glow(trace, crossing, delay) * alpha;
    disc_stokes_times(alpha);
#endif
    float whole = 1.0;   // of its opacity, within its rims
#ifdef EFFECT_TRANSLUCENT_DISC
    whole = disc_whole(disc_depth(crossing.r));
    float opacity = frame.disc_surface.x * whole;
#else
    float opacity = 1.0;
#endif
#ifdef EFFECT_DISC_GAS
    DiscGas gas = disc_gas(crossing, delay, whole);
    vec3 light = frame.disc_gas_colour.rgb * (gas.light * opacity * alpha);
    alpha *= 1.0 - disc_gas_gaps(gas, opacity);
#else
    vec4 texel = disc_painted(crossing, delay);
    alpha *= texel.a * opacity;
    vec3 light = texel.rgb * frame.disc_surface.z * alpha;
#endif
#ifdef EFFECT_THERMAL_DISC
    DiscMatter matter = disc_matter(trace, crossing);
    light = polarised_light(light * thermal_light(matter), disc_matter_polarised(trace, crossing, matter));
#endif
#ifdef SLOT_DISC_GLOW
    light += glow;
#endif
    return vec4(light, alpha);
}
