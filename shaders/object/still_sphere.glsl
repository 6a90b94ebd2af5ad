// A sphere about the centre that keeps its size, where rays are marched along.
#include "path/place"
#include "object/sphere.glsl"
#include "shared/objects.glsl"

float sphere_value(int i, RayPlace place) { return place.r - body_form(i).x; }

// A ray that skims it comes closer only as fast as it is steep, and as light bends: by SPHERE_BEND/r^2 at most.
#define SPHERE_BEND 2.0
float sphere_room(int i, RayPlace place) {
    float steep = abs(dot(place_velocity(place), place.outward)) / max(place_speed(place), 1.0e-20);
    float value = max(sphere_value(i, place), 0.0);
    return 2.0 * value / (steep + sqrt(steep * steep + 2.0 * SPHERE_BEND * value / (place.r * place.r)) + 1.0e-20);
}
