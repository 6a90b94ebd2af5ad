// Operations of formulas (src/expr/formula.h): a value for every input, so that no NaN and no infinity comes out.
#include "core/trig.glsl"

float expression_bounded(float x) { return clamp(x, -1.0e30, 1.0e30); }

float expression_turn(float angle) { return clamp(angle, -1.0e6, 1.0e6); }

float expression_divide(float a, float b) {
    return expression_bounded(a / (abs(b) < 1.0e-30 ? (b < 0.0 ? -1.0e-30 : 1.0e-30) : b));
}

float expression_power(float a, float b) { return exp(clamp(expression_bounded(b * log(max(a, 1.0e-30))), -69.0, 69.0)); }

// n: a constant of the formula, 0 ... 16.
float expression_whole_power(float base, int n) {
    float result = 1.0;
    for (int i = 0; i < n; ++i) result = expression_bounded(result * base);
    return result;
}

float expression_atan(float y, float x) { return bearing(y, x); }

float expression_mix(float a, float b, float t) {
    return expression_bounded(a + expression_bounded(expression_bounded(b - a) * t));
}

float expression_smooth(float low, float high, float x) {
    float t = clamp(expression_divide(x - low, high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float expression_mod(float a, float b) { return expression_bounded(a - expression_bounded(b * floor(expression_divide(a, b)))); }

// Scaled, so that squares stay within a float.
float expression_length(vec3 x) {
    float largest = max(max(abs(x.x), abs(x.y)), max(abs(x.z), 1.0e-30));
    vec3 scaled = x / largest;
    return expression_bounded(largest * sqrt(dot(scaled, scaled)));
}

// A lattice point's number in [0, 1): three odd multipliers, then mixed by shifts.
float expression_lattice(ivec3 at) {
    uint h = uint(at.x) * 0x9E3779B1u ^ uint(at.y) * 0x85157AF5u ^ uint(at.z) * 0xC3D2E1F1u;
    h ^= h >> 16u;
    h *= 0x7FEB352Du;
    h ^= h >> 15u;
    h *= 0x6C8E9CF5u;
    h ^= h >> 16u;
    return float(h >> 8u) * 5.9604644775390625e-8;
}

// Value noise in [0, 1].
float expression_noise(vec3 place) {
    vec3 x = clamp(place, vec3(-1.0e6), vec3(1.0e6));
    vec3 whole = floor(x);
    vec3 t = x - whole;
    t = t * t * (3.0 - 2.0 * t);
    ivec3 i = ivec3(whole);
    vec4 low = vec4(expression_lattice(i), expression_lattice(i + ivec3(0, 1, 0)), expression_lattice(i + ivec3(0, 0, 1)),
                    expression_lattice(i + ivec3(0, 1, 1)));
    vec4 high = vec4(expression_lattice(i + ivec3(1, 0, 0)), expression_lattice(i + ivec3(1, 1, 0)),
                     expression_lattice(i + ivec3(1, 0, 1)), expression_lattice(i + ivec3(1, 1, 1)));
    vec4 rows = mix(low, high, t.x);
    vec2 planes = mix(rows.xz, rows.yw, t.y);
    return mix(planes.x, planes.y, t.z);
}
