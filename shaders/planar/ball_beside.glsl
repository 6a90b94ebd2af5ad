// A ball that a ray passes by.
#include "planar/trace.glsl"
#include "object/ball.glsl"
#include "planar/place.glsl"
#include "shared/objects.glsl"

// A ray stays in a plane through the centre: where that passes the ball by, with a pixel's width to spare, there is nothing to march
// for. tangent: place_tangent.
bool ball_beside(int i, Trace trace, vec3 tangent) {
    vec3 middle = body_form(i).xyz;
    float reach = sqrt(dot(middle, middle)) + body_form(i).w;
    float pixel = reach * trace.pixel_angle / trace_sine(trace);
    return abs(dot(cross(radial_direction(), tangent), middle)) > body_form(i).w + pixel;
}
