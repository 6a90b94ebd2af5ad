// A solid given by a formula, f(x, y, z) < 0, as far as a sphere about the centre. What is marched along is f over the length of its
// gradient: a distance close to the surface, with the sign of f everywhere.

float surface_inside(vec3 at) {   // below 0 inside
    float f = surface_formula(at);
    return max(f, sqrt(dot(at, at)) - frame.surface_form.x);
}

vec3 surface_gradient(vec3 at) {
    float h = frame.surface_form.z;
    return vec3(surface_inside(at + vec3(h, 0.0, 0.0)) - surface_inside(at - vec3(h, 0.0, 0.0)),
                surface_inside(at + vec3(0.0, h, 0.0)) - surface_inside(at - vec3(0.0, h, 0.0)),
                surface_inside(at + vec3(0.0, 0.0, h)) - surface_inside(at - vec3(0.0, 0.0, h))) * (0.5 / h);
}

float surface_value(vec3 at) {
    vec3 slope = clamp(surface_gradient(at), vec3(-1.0e15), vec3(1.0e15));
    return surface_inside(at) / max(sqrt(dot(slope, slope)), 1.0e-12);
}

// How far a stride may go: not by f, which need not be a distance.
float surface_room(vec3 at) { return max(sqrt(dot(at, at)) - frame.surface_form.x, frame.surface_form.y); }

vec3 surface_normal(vec3 at) {
    vec3 slope = clamp(surface_gradient(at), vec3(-1.0e15), vec3(1.0e15));
    return slope / max(sqrt(dot(slope, slope)), 1.0e-12);
}
