// A sphere about the centre that pulsates. Its form: mean radius, the amplitude, the phase now and its rate.
#include "path/place"
#include "object/sphere.glsl"
#include "object/unseen.glsl"
#include "shared/objects.glsl"

float pulse_value(int i, RayPlace place) {
    vec4 form = body_form(i);
    return max(place.r - form.x * (1.0 + form.y * sin(form.z - form.w * place.delay)), solid_unseen(place.r));
}

// It comes to meet the ray: both move.
float pulse_room(int i, RayPlace place) {
    vec4 form = body_form(i);
    return pulse_value(i, place) / (1.0 + form.x * form.y * form.w * place_slowness(place));
}

float pulse_size(int i) { return sphere_size(i); }
vec3 pulse_middle(int i, RayPlace place) { return sphere_middle(i, place); }
vec3 pulse_normal(int i, RayPlace place) { return sphere_normal(i, place); }
