// How fast the disc's matter goes round.
#include "path/trace"
#include "shared/frame.glsl"

// Omega of circular orbits and its slope by zeta = 1/r. Omega = w/(1 + a w), w^2 = zeta^3 (z - w zeta) of disc_winding: about a rotating
// hole with its rotation.
vec2 disc_orbit(float zeta) {
    float w = sqrt(max(zeta * zeta * zeta * (frame.disc_winding.z - frame.disc_winding.w * zeta), 0.0));
    float w_slope = 0.5 * zeta * zeta * (3.0 * frame.disc_winding.z - 4.0 * frame.disc_winding.w * zeta) / max(w, 1.0e-20);
    float dragged = 1.0 / (1.0 + path_spin() * w);
    return vec2(w, w_slope * dragged) * dragged;
}
