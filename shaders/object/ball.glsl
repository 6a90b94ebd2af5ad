// A sphere anywhere, at rest. Its form: middle, radius.
#ifdef MARCH_PASSES
#include "object/passing.glsl"
#endif
#include "path/place"
#include "shared/objects.glsl"

float ball_size(int i) { return body_form(i).w; }
vec3 ball_middle(int i, RayPlace place) { return body_form(i).xyz; }

float ball_value(int i, RayPlace place) {
    vec3 offset = place.at - ball_middle(i, place);
    return sqrt(dot(offset, offset)) - body_form(i).w;
}
float ball_least(int i, RayPlace place) { return ball_value(i, place); }   // of its room
#ifdef MARCH_PASSES
Passing ball_passing(int i, RayPlace place) {
    return passing_ball(place, place.at - ball_middle(i, place), body_form(i).w, passing_course(place), passing_bend(place), ball_value(i, place));
}
float ball_room(int i, RayPlace place) { return ball_passing(i, place).room; }
float ball_stride(int i, RayPlace place) { return ball_passing(i, place).stride; }
#else
float ball_room(int i, RayPlace place) { return ball_value(i, place); }
float ball_stride(int i, RayPlace place) { return ball_room(i, place); }
#endif
vec3 ball_normal(int i, RayPlace place) { return (place.at - ball_middle(i, place)) / body_form(i).w; }
