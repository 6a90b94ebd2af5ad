// A ball that a ray passes by.
#include "planar/trace.glsl"
#include "shared/frame.glsl"

// A ray stays in a plane through the centre: where that passes the ball by, with a pixel's width to spare, there is nothing to march
// for. tangent: place_tangent.
bool ball_beside(Trace trace, vec3 tangent) {
    vec3 middle = vec3(frame.ball_form.x, frame.ball_form.y, frame.ball_form.z);
    float reach = sqrt(dot(middle, middle)) + frame.ball_form.w;
    float pixel = reach * trace.pixel_angle / max(trace.s, 1.0e-9);
    return abs(dot(cross(radial_direction(), tangent), middle)) > frame.ball_form.w + pixel;
}
