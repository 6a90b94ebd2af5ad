// Method table: the deflection table itself on the GPU, indexed by (q, zeta0) through core/table_mapping.glsl. Closed-form
// logarithm plus the remainder R (table/deflection_table.h); the branch for rays through the photon sphere keeps a0 and a1 only,
// whose integrals do not cancel in float.
//
// The texture holds TABLE_SIZE + 1 nodes a side, the through branch below the turning one.
#ifdef TABLE_HERMITE
#include "core/patch.glsl"
#endif
#include "core/table_mapping.glsl"
#include "core/trig.glsl"
#include "method/by_angle.glsl"
#include "shared/frame.glsl"

uniform highp sampler2D table_texture;

#ifdef TABLE_CUBIC
vec4 lagrange_weights(float f) {   // nodes -1, 0, 1, 2
    float a = f + 1.0;
    float b = f - 1.0;
    float c = f - 2.0;
    return vec4(-f * b * c / 6.0, a * b * c * 0.5, -a * f * c * 0.5, a * f * b / 6.0);
}

float table_remainder(float x, float y, int branch) {
    float px = x * float(TABLE_SIZE);
    float py = y * float(TABLE_SIZE);
    int ix = clamp(int(px) - 1, 0, TABLE_SIZE - 3);
    int iy = clamp(int(py) - 1, 0, TABLE_SIZE - 3);
    vec4 wx = lagrange_weights(px - float(ix + 1));
    vec4 wy = lagrange_weights(py - float(iy + 1));
    float sum = 0.0;
    for (int j = 0; j < 4; ++j) {
        int row = iy + j + branch * (TABLE_SIZE + 1);
        vec4 line = vec4(texelFetch(table_texture, ivec2(ix, row), 0).x, texelFetch(table_texture, ivec2(ix + 1, row), 0).x,
                         texelFetch(table_texture, ivec2(ix + 2, row), 0).x, texelFetch(table_texture, ivec2(ix + 3, row), 0).x);
        sum += wy[j] * dot(wx, line);
    }
    return sum;
}
#else
#ifdef TABLE_HARDWARE
float table_remainder(float x, float y, int branch) {
    vec2 place = vec2(x * float(TABLE_SIZE) + 0.5, y * float(TABLE_SIZE) + 0.5 + float(branch * (TABLE_SIZE + 1)));
    return textureLod(table_texture, place / vec2(float(TABLE_SIZE + 1), float(2 * (TABLE_SIZE + 1))), 0.0).x;
}
#else
// By the four nodes about a place. TABLE_HERMITE: texels (R, dR/dx, dR/dy, d2R/dxdy) per cell.
float table_remainder(float x, float y, int branch) {
    float px = min(x * float(TABLE_SIZE), float(TABLE_SIZE) - 0.001);
    float py = min(y * float(TABLE_SIZE), float(TABLE_SIZE) - 0.001);
    int ix = int(px);
    int iy = int(py);
    float f = px - float(ix);
    float g = py - float(iy);
    int row = iy + branch * (TABLE_SIZE + 1);
    vec4 t00 = texelFetch(table_texture, ivec2(ix, row), 0);
    vec4 t10 = texelFetch(table_texture, ivec2(ix + 1, row), 0);
    vec4 t01 = texelFetch(table_texture, ivec2(ix, row + 1), 0);
    vec4 t11 = texelFetch(table_texture, ivec2(ix + 1, row + 1), 0);
#ifdef TABLE_HERMITE
    return patch_value(patch_edges(f, t00, t10, t01, t11), g);
#else
    return mix(mix(t00.x, t10.x, f), mix(t01.x, t11.x, f), g);
#endif
}
#endif
#endif

Sweep sweep_to_sky(StripRay ray, float s, float c) {
    float omk2 = one_minus_k2_of(ray, s, c);
    float k = frame.orbit.x / max(s, 1.0e-30);
    bool turning = omk2 > 0.0;
    float kp2 = max(omk2, 1.0e-12);
    float t = k * c;
    float root = sqrt(kp2 + t * t);
    float log_turning = t > 0.0 ? log((1.0 + k) / (t + root)) : log((1.0 + k) * (root - t) / kp2);
    float turning_part = frame.orbit.z * log_turning + 0.5 * frame.series.x * (k - t * root + kp2 * log_turning);
    float d2 = max(-omk2, 1.0e-12);
    float c0 = frame.orbit.y;
    float root0 = sqrt(c0 * c0 + d2);
    float log_through = c0 > 0.0 ? log((1.0 + k) / (c0 + root0)) : log((1.0 + k) * (root0 - c0) / d2);
    float through_part = frame.orbit.z * log_through + frame.orbit.w * (1.0 - c0 * c0) / (k + root0);
    float x = turning ? turning_x_from_one_minus_k(kp2 / (1.0 + k)) : through_x_from_k_minus_one(d2 / (1.0 + k));
    float y = table_y_from_angle(turning ? arc_tangent2(s, c) : frame.series.y);
    float rest = table_remainder(clamp(x, 0.0, 1.0), y, turning ? 0 : 1);
    return sweep_by_angle(turning ? turning_part + rest : through_part + rest / k, s, c);
}
