// Relativistic aberration in product form: the sky of a moving camera is the static sky with tan(theta/2) about the direction
// of motion divided by the stretch S = sqrt((1+v)/(1-v)) (Penrose 1959). Exact to rounding for rays along and against it.

struct Aberration {
    vec3 direction;   // unit view direction as the static observer sees it
    float squeeze;    // angles in the static frame over angles in the camera's
    float doppler;    // frequency in the camera over frequency in the static frame
};

// n: unit view direction in the camera's rest frame (world axes); motion: unit. stretch >= 1: of directions, colour: of frequencies.
// They are the same, but where one of both is left out: 1.
Aberration aberrate(vec3 n, vec3 motion, float stretch, float colour) {
    vec3 minus = n - motion;
    vec3 plus = n + motion;
    float one_minus_c = 0.5 * dot(minus, minus);
    float one_plus_c = 0.5 * dot(plus, plus);
    vec3 across = one_minus_c < 1.0 ? minus + one_minus_c * motion : plus - one_plus_c * motion;
    float squeezed = stretch * stretch * one_minus_c;
    float scale = 1.0 / (one_plus_c + squeezed);
    Aberration result;
    result.squeeze = 2.0 * stretch * scale;
    result.doppler = (colour * one_plus_c + squeezed / colour) * scale;
    result.direction = ((one_plus_c - squeezed) * scale) * motion + result.squeeze * across;
    return result;
}
