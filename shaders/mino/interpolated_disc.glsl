// The disc about a rotating hole at a crossing that is interpolated (stage/disc_fit.glsl). As mino/disc.glsl.
#include "mino/disc_crossing.glsl"
#include "mino/disc_footprint.glsl"
#include "mino/disc_photon.glsl"
#include "mino/interpolated.glsl"
#ifdef EFFECT_REFINE
#include "mino/ray_way.glsl"
#endif
#include "shared/frame.glsl"

// told: place, delay, d zeta/d tau; along, across: how the place moves from ray to ray.
DiscCrossing crossing_told(Trace trace, float number, vec4 told, vec2 along, vec2 across) {
    DiscCrossing crossing = no_crossing();
    crossing.number = number + 1.0;
    crossing.place = told.xy;
    crossing.r = max(length(told.xy), 1.0e-6);
    crossing.climb = told.w;
#ifdef NEEDS_RISE
    crossing.rise = trace.rise;
#endif
#ifdef NEEDS_LIGHT_TIMES
    crossing.delay = told.z;
#endif
    crossing = with_footprint(crossing, !kept_as_points(), along, across, trace.pixel_angle);
    crossing.hit = on_disc(crossing);
    return crossing;
}

#ifdef EFFECT_REFINE
// As kept_way (mino/kept_crossings.glsl). other: what the plane's other crossing adds (stage/disc_fit.glsl).
float told_way(DiscCrossing crossing, bool escapes, vec3 other) {
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    bool on = crossing.r >= inner && crossing.r <= outer;
    bool covered = on && frame.disc_surface.x >= 1.0 && frame.disc_surface.y == 0.0;
    float way = spin_way(escapes, other.x + (crossing.r < inner ? 1.0 : 0.0), other.y + (crossing.r > outer ? 1.0 : 0.0));
#ifdef EFFECT_NARROW_DISC
    bool before = crossing.number == 1.0 && crossing.climb > 0.0 && crossing.r > outer;
    way += 4.0 * max(other.z, before ? 1.0 : 0.0);
#endif
    return covered ? 0.0 : way;
}
#endif
