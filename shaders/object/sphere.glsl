// A sphere about the centre; the x of its form is its radius, of one that pulsates the mean one.
#include "path/place"
#include "shared/objects.glsl"

float sphere_size(int i) { return body_form(i).x; }
vec3 sphere_middle(int i, RayPlace place) { return vec3(0.0); }
vec3 sphere_normal(int i, RayPlace place) { return place.outward; }
