// g of a body's light about a rotating hole: by observers without angular momentum (ZAMO). As planar/glow.glsl, but that at rest is whose
// four-velocity is along that of observers at rest in the coordinates: dark within the ergosphere. numbers: not used.
#include "mino/place.glsl"
#include "mino/trace.glsl"
#include "shared/frame.glsl"

#define GLOW_LEAST_SINE 1.0e-6   // next to the axis east is a matter of choice

// What a ZAMO there measures with.
struct GlowFrame {
    vec3 outward;     // of (r, theta, phi) taken as flat spherical coordinates, world axes
    vec3 southward;
    vec3 eastward;
    float r;
    float sine;
    float lapse;
    float omega;
    float by_r;      // sqrt(g_rr), ...
    float by_theta;    // ... of g_theta theta
    float by_phi;    // ... of g_phi phi
    float rest;       // -g_tt
};

GlowFrame glow_frame(vec3 at) {
    GlowFrame f;
    f.r = max(sqrt(dot(at, at)), 1.0e-6);
    f.outward = at / f.r;
    float across = sqrt(at.x * at.x + at.y * at.y);
    vec2 azimuth = across > 0.0 ? vec2(at.x, at.y) / across : vec2(1.0, 0.0);
    float cosine = f.outward.z;
    f.sine = max(across / f.r, GLOW_LEAST_SINE);
    f.southward = vec3(cosine * azimuth.x, cosine * azimuth.y, -f.sine);
    f.eastward = vec3(-azimuth.y, azimuth.x, 0.0);
    float a = frame.spin_hole.x;
    float pull = f.r - frame.spin_turn.z;   // 2 m(r) r
    float sigma = f.r * f.r + a * a * cosine * cosine;
    float delta = max((f.r - frame.spin_hole.z) * (f.r - frame.spin_hole.w), 1.0e-7 * f.r * f.r);
    float wide = f.r * f.r + a * a;
    float area = wide * wide - a * a * delta * f.sine * f.sine;
    f.lapse = sqrt(sigma * delta / area);
    f.omega = a * pull / area;
    f.by_r = sqrt(sigma / delta);
    f.by_theta = sqrt(sigma);
    f.by_phi = f.sine * sqrt(area / sigma);
    f.rest = 1.0 - pull / sigma;
    return f;
}

float rest_g(Trace trace, RayPlace place, vec4 numbers) { return g_of(trace) * sqrt(max(glow_frame(place.at).rest, 0.0)); }

float moving_g(Trace trace, RayPlace place, vec4 numbers, vec3 middle, vec3 velocity) {
    GlowFrame m = glow_frame(middle);
    vec3 w = (dot(velocity, m.outward) * m.by_r * m.outward + dot(velocity, m.southward) * (m.by_theta / m.r) * m.southward +
              m.by_phi * (dot(velocity, m.eastward) / (m.r * m.sine) - m.omega) * m.eastward) / m.lapse;
    GlowFrame f = glow_frame(place.at);
    float energy = (trace.energy - f.omega * trace.momentum) / f.lapse;
    float east = trace.momentum / (f.by_phi * max(energy, 1.0e-6));
    vec2 back = vec2(dot(place.velocity, f.outward) * f.by_r, dot(place.velocity, f.southward) * (f.by_theta / f.r));
    back *= sqrt(max(1.0 - east * east, 0.0) / max(dot(back, back), 1.0e-30));   // against the photon's
    float ahead = 1.0 + back.x * dot(w, f.outward) + back.y * dot(w, f.southward) - east * dot(w, f.eastward);
    float frequency = ahead * (trace.energy - m.omega * trace.momentum) / m.lapse;
    float slow = max(1.0 - dot(w, w), 0.0);
    return frequency > 0.0 ? trace.doppler * sqrt(slow) / max(frequency, 1.0e-9) : 0.0;
}
