// A place on a ray in matter, and what matter there does to its light; how matter moves that goes round about the axis, in metrics of
// Kerr's form and in those with A = Delta/r^2 (a = 0). Reads the global `frame` (FrameData).
//
// Each kind of matter has a file that defines
//     MediumLight medium_light(MediumPlace place)
//     float medium_free(float r, float cosine)      how far matter is at least, r_s; not above 0 within it
//
// The camera's photon of unit frequency has the affine parameter dlambda. In matter that sees it with the frequency 1/g the ray is
// dlambda/g long, and I/nu^3 is the same for all observers: of an emissivity j(nu) the camera gets g^3 j(nu/g) dlambda/g, and the optical
// depth is alpha(nu/g) dlambda/g.
#include "shared/frame.glsl"

struct MediumPlace {
    vec3 at;          // r_s, world axes ...
#ifdef EFFECT_SPIN
    float turn;       // ... but for this azimuth, in the coordinates of the matter
#endif
    float r;
    float cosine;     // of the polar angle
    float energy;     // of the photon, at infinity, and its angular momentum about the axis (r_s): both over its frequency in the camera
    float momentum;
    vec3 begin;       // of the sample, r_s
    vec3 way;         // from there to its end
    float pixel;      // how wide a pixel is there, as if light went straight, r_s
#ifdef NEEDS_PLACE_LATE
    float delay;      // how long ago, by the camera's clock, the light left
#endif
};

struct MediumLight {
    vec3 emission;    // light for each r_s of the affine parameter
    float absorption; // optical depth for the same
    float step;       // length of the march that is short enough here, r_s
};

#define MEDIUM_INWARD 0.1   // of the distance to the horizon: what a sample may come nearer to it, or go away
#define MEDIUM_ROUND 0.1    // rays that climb less than this have no longer samples

float medium_to_horizon(MediumPlace place) {
    float climb = abs(dot(place.way, place.at)) * inversesqrt(max(dot(place.way, place.way), 1.0e-24)) / place.r;
    return MEDIUM_INWARD * (place.r - frame.medium_hole.y) / max(climb, MEDIUM_ROUND);
}

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
