// A sphere about the centre that pulsates: sphere_form holds its mean radius, the swing, the phase now and its rate.
#include "path/place"
#include "shared/frame.glsl"

float sphere_value(RayPlace place) {
    return place.r - frame.sphere_form.x * (1.0 + frame.sphere_form.y * sin(frame.sphere_form.z - frame.sphere_form.w * place.late));
}

// It comes to meet the ray: both move.
float sphere_room(RayPlace place) { return sphere_value(place) / (1.0 + frame.sphere_form.x * frame.sphere_form.y * frame.sphere_form.w * place_slowness(place)); }
