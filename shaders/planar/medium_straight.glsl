// A ray through matter by its length, r_s, where light is not bent: past the centre, where its angle turns at once, too.
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#define MEDIUM_BY_LENGTH true

float medium_end(Trace trace, float until) {
    float r0 = 1.0 / frame.shift.y;
    float ahead = trace.s * cos(until) - trace.c * sin(until);   // sine of what is left of the angle
    return until < trace.phi_end ? r0 * sin(until) / max(ahead, 1.0e-9) : r0 + frame.medium_bound.x;
}

RayPlace medium_at(Trace trace, vec3 tangent, float along) {
    vec3 direction = trace.c * radial_direction() + sideways(trace.side);
    RayPlace place;
    place.at = radial_direction() / frame.shift.y + along * direction;
    place.r = sqrt(max(dot(place.at, place.at), 1.0e-12));
    place.outward = place.at / place.r;
    place.r_along = dot(direction, place.outward);
    place.r_across = 0.0;
    place.onward = (direction - place.r_along * place.outward) / place.r;
#ifdef NEEDS_PLACE_LATE
    place.delay = 0.0;
#ifdef EFFECT_DELAY
    place.delay = along;
    place.time_slope = vec2(0.0);
    place.doubt = 0.0;
#endif
#endif
    return place;
}

#ifdef NEEDS_PLACE_LATE
RayPlace medium_late(Trace trace, RayPlace place, float along) { return place; }
RayPlace medium_next(Trace trace, vec3 tangent, float along, RayPlace from, float from_along) { return medium_at(trace, tangent, along); }
#endif

float medium_part(RayPlace place, float length) { return length; }

float medium_rate(Trace trace) { return trace.doppler; }
