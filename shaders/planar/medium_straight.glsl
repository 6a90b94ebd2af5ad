// A ray through matter where light is not bent: by its length from where it is closest to the centre, r_s. Lengths from a distant camera would
// have the rounding of its distance.
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#define MEDIUM_BY_LENGTH true

// At the camera, or where matter may begin.
float medium_start(Trace trace) { return max(trace.c / frame.shift.y, -frame.medium_bound.x); }

float medium_end(Trace trace, float until) {
    float turn_sine = sin(until);
    float turn_cosine = cos(until);
    // Sine and cosine of what is left of the angle.
    float ahead = trace.s * turn_cosine - trace.c * turn_sine;
    float along = trace.c * turn_cosine + trace.s * turn_sine;
    float there = trace.s / frame.shift.y * along / max(ahead, 1.0e-20);
    return until < trace.phi_end ? min(there, frame.medium_bound.x) : frame.medium_bound.x;
}

RayPlace medium_at(Trace trace, vec3 tangent, float along) {
    vec3 e = radial_direction();
    vec3 direction = trace.c * e + sideways(trace.side);
    vec3 closest = trace.s / frame.shift.y * (trace.s * e - trace.c * tangent);
    RayPlace place;
    place.at = closest + along * direction;
    place.r = sqrt(max(dot(place.at, place.at), 1.0e-12));
    place.outward = place.at / place.r;
    place.r_along = dot(direction, place.outward);
    place.r_across = 0.0;
    place.onward = (direction - place.r_along * place.outward) / place.r;
#ifdef NEEDS_PLACE_LATE
    place.delay = 0.0;
#ifdef EFFECT_DELAY
    place.delay = along - (trace.c > 0.0 ? 1.0 + trace.c : trace.s * trace.s / (1.0 - trace.c)) / frame.shift.y;
    place.time_slope = vec2(0.0);
    place.doubt = 0.0;
#endif
#endif
    return place;
}

RayPlace medium_late(Trace trace, RayPlace place, float along) { return place; }
RayPlace medium_next_late(Trace trace, RayPlace next, float along, RayPlace from, float from_along) { return next; }

float medium_part(RayPlace place, float length) { return length; }
float medium_to_wedge(RayPlace place) { return 0.0; }

float medium_rate(Trace trace) { return trace.doppler; }
