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
vec2 way_ask(MarchWay way, RayPlace place) {
    vec2 asked = march_ask(place);
    return vec2(place.r > way.ray.outer ? asked.x : 1.0e30, asked.y);
}
float way_value(MarchWay way, RayPlace place) { return way_ask(way, place).x; }
// As if light went straight.
float way_pixel(MarchWay way, RayPlace place, float s) { return way.pixel_angle * way.length; }
float way_pixel_least(MarchWay way, RayPlace place, float s) { return way_pixel(way, place, s); }
// How far there is a way before and after: steps are polynomials.
float way_left(MarchWay way, float s) { return 0.5; }
