// A place on a ray in matter, and what matter there does to its light. Reads the global `frame` (FrameData).
//
// The camera's photon of unit frequency has the affine parameter dlambda. In matter that sees it with the frequency 1/g the ray is
// dlambda/g long, and I/nu^3 is the same for all observers: of an emissivity j(nu) the camera gets g^3 j(nu/g) dlambda/g, and the optical
// depth is alpha(nu/g) dlambda/g.
#include "shared/frame.glsl"

struct MediumPlace {
    vec3 at;          // r_s, world axes ...
    float turn;       // ... but for this azimuth, in the coordinates of the matter (path/azimuth); 0 where rays stay in planes
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

#ifdef MEDIUM_STOKES
// What a law adds of polarised light: Q, U, V of the camera's screen.
struct MediumStokes {
    vec3 emitted;     // over I
    vec3 absorbed;    // over the absorption of I
    vec3 turned;      // Faraday's conversion (Q, U) and rotation (V) for each r_s of the affine parameter, rad
};
#endif

#define MEDIUM_INWARD 0.1   // of the distance to the horizon: what a sample may come nearer to it, or go away
#define MEDIUM_ROUND 0.1    // rays that climb less than this have no longer samples

float medium_to_horizon(MediumPlace place) {
    float climb = abs(dot(place.way, place.at)) * inversesqrt(max(dot(place.way, place.way), 1.0e-24)) / place.r;
    return MEDIUM_INWARD * (place.r - frame.medium_hole.y) / max(climb, MEDIUM_ROUND);
}
