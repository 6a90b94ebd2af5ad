// The baseline for mino/kerr.glsl: Hamilton's equations in Cartesian Kerr-Schild coordinates, the classic fourth-order Runge-Kutta step by
// step, as most renderers of rotating holes do it. A sky alone. What is traced is the ray's mirror image under (t, phi) -> (-t, -phi), which
// falls in where the chart is regular. KERR_SCHILD_STEP: of a step, times the radius.
#include "mino/ray.glsl"
#include "shared/frame.glsl"

#define KERR_SCHILD_MOST 20000
#define KERR_SCHILD_SKY 2000.0    // radius, r_s, where a ray's motion is taken for its direction: 3e-6 rad are left at an impact parameter of 10
#define KERR_SCHILD_FAR 16.0      // radius from which on steps outward grow as its square

struct KerrSchildState {
    vec3 at;
    vec3 p;
};

float kerr_schild_radius(float a, vec3 at) {
    float flat_part = dot(at, at) - a * a;
    float az = a * at.z;
    float root = sqrt(flat_part * flat_part + 4.0 * az * az);
    return sqrt(max(0.5 * (flat_part + root), 1.0e-12));
}

// d/dlambda of both, of H = (eta^{mu nu} p p - f (l p)^2)/2 with p_t = -1.
KerrSchildState kerr_schild_slope(float a, float c, KerrSchildState s) {
    float r = kerr_schild_radius(a, s.at);
    float r2 = r * r;
    float across = r2 + a * a;
    float sum = 1.0 / (r2 * r2 + a * a * s.at.z * s.at.z);
    float f = r2 * (r - c) * sum;   // 2 m(r) r^3/(r^4 + a^2 z^2)
    float by_across = 1.0 / across;
    float by_r = 1.0 / r;
    vec3 l = vec3((r * s.at.x + a * s.at.y) * by_across, (r * s.at.y - a * s.at.x) * by_across, s.at.z * by_r);
    float lp = 1.0 + dot(l, s.p);
    KerrSchildState d;
    d.at = s.p - (f * lp) * l;
    vec3 dr = vec3(s.at.x * r2 * r, s.at.y * r2 * r, s.at.z * r * across) * sum;
    vec3 df = f * ((3.0 + c / (r - c)) * by_r * dr - sum * (4.0 * r2 * r * dr + vec3(0.0, 0.0, 2.0 * a * a * s.at.z)));
    // sum over i of p_i dl_i/dx_k.
    vec3 pl = ((s.at.x * s.p.x + s.at.y * s.p.y - 2.0 * r * (l.x * s.p.x + l.y * s.p.y)) * by_across - l.z * s.p.z * by_r) * dr +
              vec3(r * s.p.x - a * s.p.y, a * s.p.x + r * s.p.y, 0.0) * by_across + vec3(0.0, 0.0, s.p.z * by_r);
    d.p = 0.5 * lp * lp * df + f * lp * pl;
    return d;
}

// The sky's direction, and the number of steps: below 0 for a ray that ends at the horizon.
vec4 kerr_schild_march(SpinRay ray, vec3 n) {
    float a = ray.a;
    float c = frame.spin_turn.z;
    float r = 1.0 / frame.shift.y;
    float sine = frame.spin_place.x;
    float cosine = frame.spin_place.y;
    float energy = -ray.energy;
    float across = -spin_across(n) / energy;   // of the photon over E
    float p_theta = frame.spin_energy.w * n.y / energy;
    float climb = -spin_climb(n) * r * r / energy;
    float x = r * r + a * a - a * across * sine;
    float p_r = (climb < 0.0 ? ray.k / (energy * energy) / (x - climb) : (x + climb) / ((r - ray.outer) * (r - ray.inner))) - 1.0;
    // The camera at phi~ = 0: p along d(place)/dr, d(place)/dtheta and d(place)/dphi over sin(theta).
    KerrSchildState s;
    s.at = vec3(r * sine, a * sine, r * cosine);
    vec3 by_r = vec3(sine, 0.0, cosine);
    vec3 by_theta = vec3(r * cosine, a * cosine, -r * sine);
    vec3 by_phi = vec3(-a, r, 0.0);
    vec3 n0 = cross(by_theta, by_phi);
    s.p = (p_r * n0 + p_theta * cross(by_phi, by_r) + across * cross(by_r, by_theta)) / dot(by_r, n0);
    float steps = 0.0;
    do {
        r = kerr_schild_radius(a, s.at);
        KerrSchildState k1 = kerr_schild_slope(a, c, s);
        float h = KERR_SCHILD_STEP * r * (dot(s.at, k1.at) > 0.0 ? max(1.0, r * (1.0 / KERR_SCHILD_FAR)) : 1.0);
        KerrSchildState k2 = kerr_schild_slope(a, c, KerrSchildState(s.at + 0.5 * h * k1.at, s.p + 0.5 * h * k1.p));
        KerrSchildState k3 = kerr_schild_slope(a, c, KerrSchildState(s.at + 0.5 * h * k2.at, s.p + 0.5 * h * k2.p));
        KerrSchildState k4 = kerr_schild_slope(a, c, KerrSchildState(s.at + h * k3.at, s.p + h * k3.p));
        s.at += (h / 6.0) * (k1.at + 2.0 * (k2.at + k3.at) + k4.at);
        s.p += (h / 6.0) * (k1.p + 2.0 * (k2.p + k3.p) + k4.p);
        r = kerr_schild_radius(a, s.at);
        steps += 1.0;
    } while (r > ray.outer && r < KERR_SCHILD_SKY && steps < float(KERR_SCHILD_MOST));
    // Azimuths turned over again, from the camera's: phi = phi_camera - (phi~ + int a/Delta dr at the camera).
    vec3 motion = normalize(kerr_schild_slope(a, c, s).at);
    float co = cos(frame.spin_turn.x);
    float si = sin(frame.spin_turn.x);
    vec2 turned = vec2(co * motion.x - si * motion.y, -(si * motion.x + co * motion.y));
    vec2 place = vec2(frame.spin_place.z * turned.x - frame.spin_place.w * turned.y, frame.spin_place.w * turned.x + frame.spin_place.z * turned.y);
    return vec4(place, motion.z, r >= KERR_SCHILD_SKY ? steps : -steps);
}
