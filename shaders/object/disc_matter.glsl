// How the disc's matter moves and how hot it is: disc_matter_texture, cells of equal ln r.
#include "effect/black_body.glsl"
#include "object/disc_crossing.glsl"
#include "object/tracer.glsl"
#include "shared/frame.glsl"

uniform highp sampler2D disc_matter_texture;
vec4 disc_matter_fetch(int i) { return texelFetch(disc_matter_texture, ivec2(i, 0), 0); }

#define DISC_MATTER_CELLS 1024

struct DiscMatter {
    float heat;   // log2 of the temperature over the hottest ring's
    float g;      // frequency in the camera over frequency in the matter
};

// Frequency of a photon in the matter, over its energy at infinity: u^t - (L_z/E) u^phi - (k_r/E) u^r. The photon's real motion is
// that of the traced ray backward: L_z/E = (n x e) . normal / (q s), k_r/E = (1/q) (d zeta / d phi) / A. About a
// spinning hole k_r/E = (d zeta / d tau) g_rr / E (core/kerr.glsl). The row's last number holds the metric's part of it.
DiscMatter disc_matter(Trace trace, DiscCrossing crossing) {
    float x = clamp(log(crossing.r * frame.disc_heat.x) * frame.disc_heat.y, 0.0, float(DISC_MATTER_CELLS) - 0.001);
    int i = int(x);
    vec4 low = disc_matter_fetch(i);
    vec4 high = disc_matter_fetch(i + 1);
    vec4 matter = low + (x - float(i)) * (high - low);
#ifdef EFFECT_SPIN
    // By frequencies, not by ratios to E: light may reach a camera in the hole with an energy below 0.
    float frequency = trace.energy * matter.y - trace.momentum * matter.z - crossing.climb * matter.w;
#else
    vec3 normal = vec3(frame.disc_normal.x, frame.disc_normal.y, frame.disc_normal.z);
    float inverse_v = 1.0 / q_sine(trace.c);
    float momentum = dot(crossed_direction(trace), normal) * inverse_v;
    float radial = trace.s * inverse_v * crossing.zeta_slope;
#endif
    DiscMatter result;
    result.heat = matter.x;
#ifdef EFFECT_SPIN
    result.g = trace.doppler / max(frequency, 1.0e-6);
    return result;
#else
    result.g = g_of(trace) / max(matter.y - momentum * matter.z - radial * matter.w, 1.0e-6);
    return result;
#endif
}

// What the heat of the disc looks like from here, linear light.
vec3 thermal_light(DiscMatter matter) {
    return seen_black_body(frame.disc_heat.z + matter.heat, matter.g, frame.disc_heat.w);
}
