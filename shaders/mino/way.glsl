// The way that is marched along: a step of a ray about a rotating hole, by the fraction of it (object/march.glsl).
#include "generated/bodies_march"
#include "mino/place.glsl"

struct MarchWay {
    SpinRay ray;
    SpinSegment segment;
    float pixel_angle;
    float length;     // of the way from the camera, r_s
};

RayPlace way_place(MarchWay way, float s) { return segment_place(way.ray, way.segment, s); }
// Outside of everything within the horizon.
float way_value(MarchWay way, RayPlace place) { return place.r > way.ray.outer ? march_value(place) : 1.0e30; }
// As if light went straight.
float way_pixel(MarchWay way, RayPlace place, float s) { return way.pixel_angle * way.length; }
// How far there is a way before and after: steps are polynomials.
float way_left(MarchWay way, float s) { return 0.5; }
