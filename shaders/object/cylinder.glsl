// A disc of finite thickness about the polar axis: |z| <= height, inner <= rho <= outer. Distance to it from outside, at least
// (exact beside its faces); below 0 inside.
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

// How far along the ray it is at least: a ray that skims a face comes closer to it only as fast as it is steep, and as light bends.
float cylinder_room(RayPlace place) {
    float rho = sqrt(place.at.x * place.at.x + place.at.y * place.at.y);
    float wall = max(rho - frame.cylinder_form.y, frame.cylinder_form.x - rho);
    vec3 velocity = place_velocity(place);
    float steep = abs(velocity.z) / max(sqrt(dot(velocity, velocity)), 1.0e-20) + 0.02;
#ifdef EFFECT_LENSING
    steep += 0.75 / place.r;
#endif
    return max(wall, (abs(place.at.z) - frame.cylinder_form.z) / min(steep, 1.0));
}
