// The way that is marched along: an orbit by its swept angle (object/march.glsl).
#include "generated/bodies_march"
#include "planar/place.glsl"

struct MarchWay {
    Trace trace;
    vec3 tangent;   // place_tangent
};

RayPlace way_place(MarchWay way, float phi) { return place_seen(way.trace, way.tangent, phi); }
float way_value(MarchWay way, RayPlace place) { return march_value(place); }
float way_pixel(MarchWay way, RayPlace place, float phi) { return place_pixel(way.trace, place, phi); }
// How far there is a way before and after.
float way_left(MarchWay way, float phi) { return 0.5 * min(phi, way.trace.phi_end - phi); }
