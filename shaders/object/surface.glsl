// A solid given by a formula, f(x, y, z) < 0, as far as a sphere about the centre. What is marched along is f over the length of its
// gradient: a distance close to the surface, with the sign of f everywhere.
#include "generated/surface"
#include "path/place"
#include "shared/frame.glsl"

// SURFACE_T and SURFACE_AT_T, of generated/surface (shaderlib/body_text.cpp): the time among the parameters, where the
// formula asks for it.

float surface_inside(vec3 at SURFACE_T) {   // below 0 inside
    float f = surface_formula(at SURFACE_AT_T);
    return max(f, sqrt(dot(at, at)) - frame.surface_form.x);
}

vec3 surface_gradient(vec3 at SURFACE_T) {
    float h = frame.surface_form.z;
    return vec3(surface_inside(at + vec3(h, 0.0, 0.0) SURFACE_AT_T) - surface_inside(at - vec3(h, 0.0, 0.0) SURFACE_AT_T),
                surface_inside(at + vec3(0.0, h, 0.0) SURFACE_AT_T) - surface_inside(at - vec3(0.0, h, 0.0) SURFACE_AT_T),
                surface_inside(at + vec3(0.0, 0.0, h) SURFACE_AT_T) - surface_inside(at - vec3(0.0, 0.0, h) SURFACE_AT_T)) * (0.5 / h);
}

#ifdef SURFACE_MOVES
float surface_time(RayPlace place) {
#ifdef NEEDS_PLACE_LATE
    return frame.surface_form.w - place.late;
#else
    return frame.surface_form.w;
#endif
}
#endif

float surface_value(RayPlace place) {
#ifdef SURFACE_MOVES
    float t = surface_time(place);
#endif
    vec3 slope = clamp(surface_gradient(place.at SURFACE_AT_T), vec3(-1.0e15), vec3(1.0e15));
    return surface_inside(place.at SURFACE_AT_T) / max(sqrt(dot(slope, slope)), 1.0e-12);
}

// How far a step may go: not by f, which need not be a distance.
float surface_room(RayPlace place) { return max(sqrt(dot(place.at, place.at)) - frame.surface_form.x, frame.surface_form.y); }

vec3 surface_normal(RayPlace place) {
#ifdef SURFACE_MOVES
    float t = surface_time(place);
#endif
    vec3 slope = clamp(surface_gradient(place.at SURFACE_AT_T), vec3(-1.0e15), vec3(1.0e15));
    return slope / max(sqrt(dot(slope, slope)), 1.0e-12);
}
