// Inverse trigonometry to float rounding on every driver. (Built-in acos, asin and atan of software drivers are off by
// 1.6e-4, 3.9e-4 and 3.4e-6 rad; asin and acos are banned in shaders.)

// atan(t)/t as a polynomial in t^2 on [0, 1]: minimax fit of scripts/fit_arctangent.py, error 1.3e-8 rad.
float arc_tangent_unit(float t) {
    float z = t * t;
    float p = 0.0020492594004690575;
    p = p * z + -0.01265689523252287;
    p = p * z + 0.036702608213945609;
    p = p * z + -0.069461808065979916;
    p = p * z + 0.10344522437755749;
    p = p * z + -0.14114268577644762;
    p = p * z + 0.19978313127170089;
    p = p * z + -0.3333204390973229;
    p = p * z + 0.99999976853751105;
    return p * t;
}

// Angle of (x, y), y >= 0, in [0, pi]; any scale; 0 for (0, 0).
float arc_tangent2(float y, float x) {
    float ax = abs(x);
    float high = max(max(ax, y), 1.0e-37);
    float a = arc_tangent_unit(min(ax, y) / high);
    float steep = 1.57079632679489661923 - a;
    a = y > ax ? steep : a;
    float back = 3.14159265358979323846 - a;
    return x < 0.0 ? back : a;
}

// Angle of (x, y) in (-pi, pi].
float bearing(float y, float x) {
    float angle = arc_tangent2(abs(y), x);
    return y < 0.0 ? -angle : angle;
}

// sin(x) for |x| <= pi/2: the series, whose next term is below 6e-8.
float sine_quarter(float x) {
    float z = x * x;
    float p = -1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return x + x * z * p;
}

// Sine and cosine of any angle of a few turns, to 2e-7. (Drivers may be off by 5e-4.)
vec2 sine_cosine(float angle) {
    float turn = angle - 6.28318530717958647692 * floor(angle * 0.15915494309189533577 + 0.5);   // [-pi, pi]
    float to_side = 1.57079632679489661923 - abs(turn);
    float within = abs(turn);
    float beyond = 1.57079632679489661923 + to_side;   // pi - |turn|
    float sine = sine_quarter(to_side < 0.0 ? beyond : within);
    float minus = -sine;
    return vec2(turn < 0.0 ? minus : sine, sine_quarter(to_side));
}
