// How matter sees the camera's light that goes round about the axis: by constants of motion alone. In metrics as medium/motion.glsl.
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

// Camera frequency over that in matter with u_mu = u_t (-1, 0, 0, l): of angular momentum l for its energy, r_s.
float medium_g(MediumPlace place, float l) {
    float a = frame.medium_hole.x;
    float r2 = place.r * place.r;
    float a2 = a * a;
    float cosine2 = place.cosine * place.cosine;
    float sine2 = max(1.0 - cosine2, 1.0e-12);
    float delta = max((place.r - frame.medium_hole.y) * (place.r - frame.medium_hole.z), 1.0e-12);
    float sigma = r2 + a2 * cosine2;
    float area = (r2 + a2) * (r2 + a2) - a2 * delta * sine2;
    float drag = a * (r2 + a2 - delta);               // 2 m(r) r a
    float around = delta / sine2 - a2;
    float norm = max(area - l * (2.0 * drag + l * around), 1.0e-12);
    // -k.u = (E (area - drag l) - L (drag + l around))/sqrt(sigma delta norm)
    float photon = place.energy * (area - drag * l) - place.momentum * (drag + l * around);
    return sqrt(sigma * delta * norm) / max(photon, 1.0e-12 * area);
}

// The same of matter that goes round at a rate, c/r_s.
float medium_g_at_rate(MediumPlace place, float rate) {
    float a = frame.medium_hole.x;
    float r2a2 = place.r * place.r + a * a;
    float cosine2 = place.cosine * place.cosine;
    float sine2 = 1.0 - cosine2;
    float delta = (place.r - frame.medium_hole.y) * (place.r - frame.medium_hole.z);
    float pull = (r2a2 - delta) / (place.r * place.r + a * a * cosine2);   // 2 m(r) r/Sigma
    float static_part = 1.0 - a * rate * sine2;
    float norm = 1.0 - pull * static_part * static_part - rate * rate * sine2 * r2a2;   // (dtau/dt)^2
    return sqrt(max(norm, 1.0e-6)) / max(place.energy - place.momentum * rate, 1.0e-6);
}

// What circles about the axis ask of the metric: sin^2(theta), Delta, Sigma, A = (r^2 + a^2)^2 - a^2 Delta sin^2(theta), 2 m(r) r a.
struct CircleMetric {
    float sine2;
    float delta;
    float sigma;
    float area;
    float drag;
};

CircleMetric circle_metric(MediumPlace place) {
    float a = frame.medium_hole.x;
    float r2a2 = place.r * place.r + a * a;
    float sine2 = max(1.0 - place.cosine * place.cosine, 1.0e-12);
    float delta = max((place.r - frame.medium_hole.y) * (place.r - frame.medium_hole.z), 1.0e-12);
    float sigma = place.r * place.r + a * a * (1.0 - sine2);
    float area = r2a2 * r2a2 - a * a * delta * sine2;
    return CircleMetric(sine2, delta, sigma, area, a * (r2a2 - delta));
}

// Of matter that goes round at a rate, c/r_s; and with angular momentum l for its energy, r_s.
MediumMatter medium_going_round(MediumPlace place, MediumMatter matter, float rate) {
    CircleMetric m = circle_metric(place);
    float speed = clamp((rate - m.drag / m.area) * m.area * sqrt(m.sine2 / m.delta) / m.sigma, -0.999999, 0.999999);
    matter.velocity = vec3(0.0, 0.0, speed * inversesqrt(1.0 - speed * speed));
    matter.g = medium_g_at_rate(place, rate);
    return matter;
}

MediumMatter medium_with_momentum(MediumPlace place, MediumMatter matter, float l) {
    CircleMetric m = circle_metric(place);
    // u_phi = -l u_t, alpha gamma = -(u_t + omega u_phi): speed = l alpha/((1 - omega l) sqrt(g_phiphi))
    float speed = clamp(l * m.sigma * sqrt(m.delta / m.sine2) / (m.area - m.drag * l), -0.999999, 0.999999);
    matter.velocity = vec3(0.0, 0.0, speed * inversesqrt(1.0 - speed * speed));
    matter.g = medium_g(place, l);
    return matter;
}
