// The way that is marched along: an orbit by its swept angle (object/march.glsl).
#include "generated/bodies_march"
#include "planar/place.glsl"

#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
#define WAY_BETWEEN   // the time of a place follows from a known one close by
#endif
#endif

struct MarchWay {
    Trace trace;
    vec3 tangent;     // place_tangent
#ifdef WAY_BETWEEN
    RayPlace known;   // a place on the span that is searched, with its time from the light-time table
    float known_phi;
#endif
};

RayPlace way_place(MarchWay way, float phi) {
#ifdef WAY_BETWEEN
    return place_beside(way.trace, way.tangent, phi, way.known, way.known_phi);
#else
    return place_of(way.trace, way.tangent, phi);
#endif
}
float way_value(MarchWay way, RayPlace place) { return march_ask(place).x; }
float way_pixel(MarchWay way, RayPlace place, float phi) { return place_pixel(way.trace, place, phi); }
// Its shorter side.
float way_pixel_least(MarchWay way, RayPlace place, float phi) {
    vec2 sides = place_pixel_sides(way.trace, place, phi);
    return min(sides.x, sides.y);
}
// How far there is a way before and after.
float way_left(MarchWay way, float phi) { return 0.5 * min(phi, way.trace.phi_end - phi); }
