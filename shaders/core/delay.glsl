// How long light was on its way from a place on the ray to the camera: a closed form that holds all that grows without bound, and the
// rest D from the delay map, in the cells of the orbit map (table/delay_column.h has the formulas).
//     t = part(place) - part(camera) + D,   part = -W/zeta + sigma (ln((1 - sigma W)/zeta) + rho),
// W = zeta'/q, sigma = 1 for rays that end in the sky, -1 for others. A = (1 - x zeta)(1 - y zeta), x, y = frame.delay.xy. The camera's
// ln(1/zeta0) + rho is formed on the host: frame.delay.z, and .w for rays that end in the horizon.

#ifdef EFFECT_LENSING
// D after the swept angle phi.
float delay_rest(bool escapes, float u, float phi, float phi_end) {
    OrbitCell cell = orbit_cell(escapes, u, phi, phi_end);
    vec4 t00 = delay_fetch(cell.column, cell.row);
    vec4 t10 = delay_fetch(cell.column + 1, cell.row);
    vec4 t01 = delay_fetch(cell.column, cell.row + 1);
    vec4 t11 = delay_fetch(cell.column + 1, cell.row + 1);
    float f = cell.across;
    float g = cell.along;
    float h1 = f * f * (3.0 - 2.0 * f);
    float h2 = f * (1.0 - f) * (1.0 - f);
    float h3 = f * f * (f - 1.0);
    float low = t00.x + h1 * (t10.x - t00.x) + h2 * t00.y + h3 * t10.y;
    float low_v = t00.z + h1 * (t10.z - t00.z) + h2 * t00.w + h3 * t10.w;
    float high = t01.x + h1 * (t11.x - t01.x) + h2 * t01.y + h3 * t11.y;
    float high_v = t01.z + h1 * (t11.z - t01.z) + h2 * t01.w + h3 * t11.w;
    return low + g * g * (3.0 - 2.0 * g) * (high - low) + g * (1.0 - g) * (1.0 - g) * low_v + g * g * (g - 1.0) * high_v;
}

// (r_* - 1/zeta + ln(zeta)): x + y times the logarithm of 1 - x zeta, and what the inner root adds; equal roots are its limit.
float delay_tortoise(float zeta) {
    float outer = frame.delay.x;
    float inner = frame.delay.y;
    float without = 1.0 - inner * zeta;
    float value = (outer + inner) * log(max(1.0 - outer * zeta, 1.0e-7));
    float by = (outer - inner) * zeta / without;      // ln(1 - by) over the difference of the roots
    float t = by / (2.0 - by);
    float series = (2.0 + t * t * (2.0 / 3.0 + t * t * (2.0 / 5.0))) * zeta / (without * (2.0 - by));
    float exact = -log(max(1.0 - by, 1.0e-7)) / max(outer - inner, 1.0e-12);
    return value - inner * inner * (by < 0.05 ? series : exact);
}

// Of the camera: W and 1 - sigma W, without a difference where one is small.
float delay_at_camera(float s, float c, float sigma) {
    float energy = energy_at(c);
    float w = -(frame.shift.z + frame.shift.x * c) / energy;
    float ahead = c < 0.0 ? s * s / (1.0 - c) : 1.0 + c;     // 1 + c
    float behind = c > 0.0 ? s * s / (1.0 + c) : 1.0 - c;
    float one_minus = sigma > 0.0 ? (frame.shift.x + frame.shift.z) * ahead / energy : (frame.shift.x - frame.shift.z) * behind / energy;
    return -w / frame.shift.y + sigma * log(max(one_minus, 1.0e-30)) + (sigma > 0.0 ? frame.delay.z : frame.delay.w);
}

// zeta, zeta_along (d zeta/d phi): of the place after the swept angle phi.
float light_time(Trace trace, float phi, float zeta, float zeta_along) {
    float sigma = trace.escapes ? 1.0 : -1.0;
    float per_q = trace.s / q_sine(trace.c);
    float fall = zeta * zeta * max((1.0 - frame.delay.x * zeta) * (1.0 - frame.delay.y * zeta), 0.0) * per_q * per_q;   // V/q^2 = 1 - W^2
    float root = sqrt(max(1.0 - fall, 0.0));
    float w = fall < 0.97 ? (zeta_along < 0.0 ? -root : root) : clamp(zeta_along * per_q, -1.0, 1.0);
    float one_minus = sigma * w > 0.0 ? fall / (1.0 + abs(w)) : 1.0 + abs(w);
    float part = -w / zeta + sigma * (log(max(one_minus, 1.0e-30) / zeta) + delay_tortoise(zeta));
    return part - delay_at_camera(trace.s, trace.c, sigma) + delay_rest(trace.escapes, trace.ray.u, phi, trace.phi_end);
}

// T = v_cam - v_inf, v = t + r_*, of a ray that ends in the sky.
float sky_delay(Trace trace) {
    float energy = energy_at(trace.c);
    float ahead = trace.c < 0.0 ? trace.s * trace.s / (1.0 - trace.c) : 1.0 + trace.c;
    float behind = trace.c > 0.0 ? trace.s * trace.s / (1.0 + trace.c) : 1.0 - trace.c;
    float lead = (frame.shift.x - frame.shift.z) * behind / energy / frame.shift.y;              // (1 + W)/zeta
    float turn = log(max(0.5 * (frame.shift.x + frame.shift.z) * ahead / energy, 1.0e-30));      // ln((1 - W)/2)
    return lead - turn + delay_rest(true, trace.ray.u, trace.phi_end, trace.phi_end);
}
#else
// Straight light: the distance.
float light_time(Trace trace, float phi, float zeta, float zeta_along) {
    float r = 1.0 / zeta;
    float r0 = 1.0 / frame.shift.y;
    float half_sine = sin(0.5 * phi);
    return sqrt((r - r0) * (r - r0) + 4.0 * r * r0 * half_sine * half_sine);
}

float sky_delay(Trace trace) { return (trace.c > 0.0 ? trace.s * trace.s / (1.0 + trace.c) : 1.0 - trace.c) / frame.shift.y; }
#endif
