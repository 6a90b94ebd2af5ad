// A disc of finite thickness about the polar axis: |z| <= height, inner <= rho <= outer. Distance to it from outside, at least
// (exact beside its faces); below 0 inside. Its form: inner and outer radius, half thickness.
#include "path/place"
#include "shared/frame.glsl"
#include "shared/objects.glsl"

float cylinder_size(int i) { return body_form(i).y; }
vec3 cylinder_middle(int i, RayPlace place) { return vec3(0.0); }

float cylinder_value(int i, RayPlace place) {
    vec3 at = place.at;
    float rho = sqrt(at.x * at.x + at.y * at.y);
    float wall = max(rho - body_form(i).y, body_form(i).x - rho);
    return max(wall, abs(at.z) - body_form(i).z);
}

vec3 cylinder_normal(int i, RayPlace place) {
    vec3 at = place.at;
    float rho = max(sqrt(at.x * at.x + at.y * at.y), 1.0e-20);
    float outer_wall = rho - body_form(i).y;
    float inner_wall = body_form(i).x - rho;
    float face = abs(at.z) - body_form(i).z;
    if (face > max(outer_wall, inner_wall)) return vec3(0.0, 0.0, at.z < 0.0 ? -1.0 : 1.0);
    vec3 outward = vec3(at.x / rho, at.y / rho, 0.0);
    return outer_wall > inner_wall ? outward : -outward;
}

// How far along the ray it is at least: a ray that skims a face or the outer wall comes closer to it only as fast as it is steep (the
// distance from the axis is convex along straight lines), and as light bends.
float cylinder_room(int i, RayPlace place) {
    float rho = max(sqrt(place.at.x * place.at.x + place.at.y * place.at.y), 1.0e-20);
    vec3 velocity = place_velocity(place);
    velocity /= max(sqrt(dot(velocity, velocity)), 1.0e-20);
    float bend = 0.02;
#ifdef EFFECT_SIDES
    bend += 0.75 * frame.throat.x / place.r;
#else
#ifdef EFFECT_LENSING
    bend += 0.75 / place.r;
#endif
#endif
    float outward = abs(place.at.x * velocity.x + place.at.y * velocity.y) / rho;
    float wall = max((rho - body_form(i).y) / min(outward + bend, 1.0), body_form(i).x - rho);
    return max(wall, (abs(place.at.z) - body_form(i).z) / min(abs(velocity.z) + bend, 1.0));
}
