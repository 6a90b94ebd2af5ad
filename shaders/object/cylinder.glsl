// A disc of finite thickness about the polar axis: |z| <= height, inner <= rho <= outer. Distance to it from outside, at least
// (exact beside its faces); below 0 inside.
#include "path/place"
#include "shared/frame.glsl"

float cylinder_value(vec3 at) {
    float rho = sqrt(at.x * at.x + at.y * at.y);
    float wall = max(rho - frame.cylinder_form.y, frame.cylinder_form.x - rho);
    return max(wall, abs(at.z) - frame.cylinder_form.z);
}

vec3 cylinder_normal(vec3 at) {
    float rho = max(sqrt(at.x * at.x + at.y * at.y), 1.0e-20);
    float outer_wall = rho - frame.cylinder_form.y;
    float inner_wall = frame.cylinder_form.x - rho;
    float face = abs(at.z) - frame.cylinder_form.z;
    if (face > max(outer_wall, inner_wall)) return vec3(0.0, 0.0, at.z < 0.0 ? -1.0 : 1.0);
    vec3 outward = vec3(at.x / rho, at.y / rho, 0.0);
    return outer_wall > inner_wall ? outward : -outward;
}

// How far along the ray it is at least: a ray that skims a face or the outer wall comes closer to it only as fast as it is steep (the
// distance from the axis is convex along straight lines), and as light bends.
float cylinder_room(RayPlace place) {
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
    float wall = max((rho - frame.cylinder_form.y) / min(outward + bend, 1.0), frame.cylinder_form.x - rho);
    return max(wall, (abs(place.at.z) - frame.cylinder_form.z) / min(abs(velocity.z) + bend, 1.0));
}
