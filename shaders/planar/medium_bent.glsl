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

RayPlace medium_next_late(Trace trace, RayPlace next, float along, RayPlace from, float from_along) { return place_timed_beside(trace, next, along, from, from_along); }
#else
RayPlace medium_late(Trace trace, RayPlace place, float along) { return place; }
RayPlace medium_next_late(Trace trace, RayPlace next, float along, RayPlace from, float from_along) { return next; }
#endif

float medium_part(RayPlace place, float length) { return min(place_part(place, length), medium_longest()); }

// After which angle the ray comes between two cones, where there is no matter beyond them; 0 between them, and where nothing is known of such.
#ifdef MEDIUM_WEDGE
float medium_to_wedge(RayPlace place) {
    // z = cos(theta) goes as a cosine of the angle: z cos(x) + slope sin(x) is MEDIUM_WEDGE.
    float z = abs(place.outward.z);
    float slope = place.outward.z < 0.0 ? -place.onward.z : place.onward.z;
    float rest = sqrt(max(z * z + slope * slope - MEDIUM_WEDGE * MEDIUM_WEDGE, 0.0));
    float there = arc_tangent2(max(slope * MEDIUM_WEDGE + z * rest, 0.0), z * MEDIUM_WEDGE - slope * rest);
    return z > MEDIUM_WEDGE ? there : 0.0;
}
#else
float medium_to_wedge(RayPlace place) { return 0.0; }
#endif

// Of the affine parameter by the angle, over r^2.
float medium_rate(Trace trace) { return trace.doppler * frame.shift.y / trace_sine(trace); }
