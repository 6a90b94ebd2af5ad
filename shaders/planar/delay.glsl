// How long light was on its way from a place on the ray to the camera: a closed form that holds all that grows without bound, and the
// rest D from the light-time table, in the cells of the orbit table (table/delay_column.h has the formulas).
//     t = part(place) - part(camera) + D,   part = -W/zeta + sigma (ln((1 - sigma W)/zeta) + rho),
// W = zeta'/q, sigma = 1 for rays that end in the sky, -1 for others. A = (1 - x zeta)(1 - y zeta), x, y = frame.delay.xy. The camera's
// ln(1/zeta0) + rho is formed on the host: frame.delay.z, and .w for rays that end in the horizon.
#include "planar/trace.glsl"
#ifdef EFFECT_LENSING
#include "core/orbit.glsl"
#include "core/patch.glsl"
#endif
#include "shared/frame.glsl"

#ifdef EFFECT_LENSING
// D after the swept angle phi.
float delay_rest(bool escapes, float u, float phi, float phi_end) {
    OrbitCell cell = orbit_cell(escapes, u, phi, phi_end);
    vec4 edges = patch_edges(cell.across, delay_fetch(cell.column, cell.row), delay_fetch(cell.column + 1, cell.row),
                             delay_fetch(cell.column, cell.row + 1), delay_fetch(cell.column + 1, cell.row + 1));
    return patch_value(edges, cell.along);
}

#ifdef EFFECT_INNER_HORIZON
// What an inner horizon adds to r_*: y^2 ln((1 - y zeta)/(1 - x zeta))/(x - y); equal roots are its limit.
float inner_horizon_time(float zeta) {
    float outer = frame.delay.x;
    float inner = frame.delay.y;
    float without = 1.0 - inner * zeta;
    float by = (outer - inner) * zeta / without;      // ln(1 - by) over the difference of the roots
    float t = by / (2.0 - by);
    float series = (2.0 + t * t * (2.0 / 3.0 + t * t * (2.0 / 5.0))) * zeta / (without * (2.0 - by));
    float exact = -log(max(1.0 - by, 1.0e-7)) / max(outer - inner, 1.0e-12);
    return inner * inner * (by < 0.05 ? series : exact);
}
#endif

// Of the camera: energy (1 - W) and energy (1 + W), W = -(b + a c)/(a + b c); products, without a difference where one is small.
vec2 delay_at_camera(Trace trace) {
    float more = 1.0 + abs(trace.c);
    float less = trace.s * trace.s / more;
    float minus = trace.c < 0.0 ? less : more;
    float plus = trace.c < 0.0 ? more : less;
    return vec2((frame.shift.x + frame.shift.z) * minus, (frame.shift.x - frame.shift.z) * plus);
}

// Of the place at r after the swept angle phi, less the camera's r (frame.delay); zeta_along: d zeta/d phi there.
float light_time(Trace trace, float phi, float r, float zeta_along) {
    float sigma = trace.escapes ? 1.0 : -1.0;
    float zeta = 1.0 / r;
    float energy = energy_at(trace.c);
    vec2 sides = delay_at_camera(trace);
    float near = max((1.0 - frame.delay.x * zeta), 1.0e-7);
    float per_q = trace.s / q_sine(trace.c);
    float slope = zeta_along * per_q;
    float fall = zeta * zeta * near * per_q * per_q;   // V/q^2 = 1 - W^2
#ifdef EFFECT_INNER_HORIZON
    fall *= max(1.0 - frame.delay.y * zeta, 0.0);
#endif
    float root = sqrt(max(1.0 - fall, 0.0));
    float downward = -root;
    float by_root = slope < 0.0 ? downward : root;
    float by_slope = clamp(slope, -1.0, 1.0);
    float w = fall < 0.97 ? by_root : by_slope;
    float larger = 1.0 + abs(w);
    float smaller = fall / larger;
    float one_minus = sigma * w > 0.0 ? smaller : larger;
    float side_out = sides.x;
    float side_in = sides.y;
    float side = trace.escapes ? side_out : side_in;
    float ratio = max(one_minus, 1.0e-30) * near * energy * r / max(side, 1.0e-30);   // both roots add up to 1
    float start = -sides.x / (energy * frame.shift.y);   // (W - 1)/zeta: from afar far less than the distance
    float logarithm = log(ratio);
#ifdef EFFECT_INNER_HORIZON
    logarithm -= inner_horizon_time(zeta);
#endif
    float rest_out = frame.delay.z;
    float rest_in = frame.delay.w;
    float rest = trace.escapes ? rest_out : rest_in;
    float time = start - w * r + sigma * logarithm - rest +
                 delay_rest(trace.escapes, trace.ray.u, phi, trace.phi_end);
#ifdef EFFECT_ZOOM
    time += ring_part(phi, frame.ring.y);
#endif
    return time;
}

// T = v_cam - v_inf, v = t + r_*, of a ray that ends in the sky.
float sky_delay(Trace trace) {
    vec2 sides = delay_at_camera(trace);
    float energy = energy_at(trace.c);
    float time = sides.y / (energy * frame.shift.y) - log(max(0.5 * sides.x / energy, 1.0e-30)) +
                 delay_rest(true, trace.ray.u, trace.phi_end, trace.phi_end);
#ifdef EFFECT_ZOOM
    time += ring_part(trace.phi_end, frame.ring.y);
#endif
    return time;
}
#else
// Straight light: the distance D, less the camera's r; a product where it is small: D^2 - r0^2 = r (r - 2 r0 cos(phi)).
float light_time(Trace trace, float phi, float r, float zeta_along) {
    float r0 = 1.0 / frame.shift.y;
    float half_sine = sin(0.5 * phi);
    float distance = sqrt((r - r0) * (r - r0) + 4.0 * r * r0 * half_sine * half_sine);
    return r * (r - 2.0 * r0 * (1.0 - 2.0 * half_sine * half_sine)) / (distance + r0);
}

float sky_delay(Trace trace) { return (trace.c > 0.0 ? trace.s * trace.s / (1.0 + trace.c) : 1.0 - trace.c) / frame.shift.y; }
#endif
