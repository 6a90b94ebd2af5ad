// What a pixel, or a ray of it, spans on the disc.
#include "effect/sampling.glsl"
#include "mino/disc_crossing.glsl"
#include "object/disc_rim.glsl"
#include "shared/frame.glsl"

#ifdef EFFECT_REFINE
#define KEPT_POINTS 6.0   // rays along a side of a pixel, from which on they are points: of an image thinner than their distance some had less than
                          // all of the disc's light by their footprint, and those beside it none, 1 % of the light in all
bool kept_as_points() { return sampling_rays() >= KEPT_POINTS; }
#else
bool kept_as_points() { return false; }
#endif

// known: its sides, as the neighbours' rays tell them; else as if the disc were looked at from here, straight.
DiscCrossing with_footprint(DiscCrossing crossing, bool known, vec2 along, vec2 across, float pixel_angle) {
    float side = pixel_angle * (crossing.r + 1.0 / frame.shift.y);
    crossing.along = known ? along : vec2(side, 0.0);
    crossing.across = known ? across : vec2(0.0, side);
    return crossing;
}

// Is a part of the pixel on the disc?
bool on_disc(DiscCrossing crossing) {
    vec4 footprint = vec4(crossing.along, crossing.across);
    float reach = min(0.5 * sqrt(dot(footprint, footprint)), disc_rim());
    return crossing.r >= frame.disc_x.w - reach && crossing.r <= frame.disc_y.w + reach;
}
