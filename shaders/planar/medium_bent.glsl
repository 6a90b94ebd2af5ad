// A ray through matter by its swept angle, where light is bent.
#include "medium/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#define MEDIUM_BY_LENGTH false

float medium_start(Trace trace) { return 0.0; }

float medium_end(Trace trace, float until) { return min(until, trace.phi_end); }

RayPlace medium_at(Trace trace, vec3 tangent, float along) { return place_of(trace, tangent, along); }

#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
#define MEDIUM_LATE
#endif
#endif

#ifdef MEDIUM_LATE
// When light left, of a place; and of the next one, from this: the light-time table is asked once a span.
RayPlace medium_late(Trace trace, RayPlace place, float along) {
    place.delay = place_light_time(trace, place, along);
    place.time_slope = place_time_slope(trace, place);
    return place;
}

RayPlace medium_next(Trace trace, vec3 tangent, float along, RayPlace from, float from_along) { return place_beside(trace, tangent, along, from, from_along); }
#else
RayPlace medium_late(Trace trace, RayPlace place, float along) { return place; }
RayPlace medium_next(Trace trace, vec3 tangent, float along, RayPlace from, float from_along) { return medium_at(trace, tangent, along); }
#endif

float medium_part(RayPlace place, float length) { return min(place_part(place, length), medium_longest()); }

// Of the affine parameter by the angle, over r^2.
float medium_rate(Trace trace) { return trace.doppler * frame.shift.y / trace_sine(trace); }
