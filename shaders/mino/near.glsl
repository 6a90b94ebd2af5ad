// Rays of a camera next to the horizon of a rotating hole, where floats lose what they are about: with x = 1 - r_+ zeta, u = 1 - r_- zeta and X of the
// photon (spin_x) the polynomials of mino/kerr.glsl are
//     Delta zeta^2 = x u,   u = 1 - r_-/r_+ + (r_-/r_+) x,   X = X_+ - a (L - a E) (x/r_+) (zeta + 1/r_+),
//     zeta'^2 = X^2 - x u zeta^2 K,   psi' = -a (E + X/(x u)).
// X_+, that at the horizon, is what of the energy does not go round with it: E and a L/(r_+^2 + a^2) are much larger and all but equal. It comes from the host
// as a form of its own, x from 1/r_+ in two floats and zeta + fine: no difference of large numbers is left.
#include "shared/frame.glsl"

struct NearHorizon {
    float outer;      // radii of the horizons
    float inner;
    float gap;        // 1 - r_-/r_+
    float x;          // X_+
    float twist;      // a (L - a E) of the tangent
};

// x
float near_above(NearHorizon near, float zeta, float fine) { return near.outer * ((frame.spin_near_2.x - zeta) + (frame.spin_near_2.y - fine)); }

// u
float near_below(NearHorizon near, float above) { return near.gap + (1.0 - near.gap) * above; }

// X
float near_x(NearHorizon near, float zeta, float above) {
    return near.x - near.twist * (above / near.outer) * (zeta + frame.spin_near_2.x);
}

// zeta'', k: Carter's K.
float near_force(NearHorizon near, float k, float zeta, float fine) {
    float above = near_above(near, zeta, fine);
    float below = near_below(near, above);
    float slope = near.outer * below + near.inner * above;   // -d(x u)/d zeta
    return zeta * (2.0 * near.twist * near_x(near, zeta, above) - k * (above * below - 0.5 * zeta * slope));
}

// What the camera's zeta lacks as a float.
float near_fine(NearHorizon near, float zeta) { return (frame.spin_near_2.x - zeta) + (frame.spin_near_2.y - frame.spin_near_2.z / near.outer); }

// log((u/x)/(u_to/x_to)): with the horizons close together both are near 1 further out, and the factor on it is large.
float near_log(NearHorizon near, float above, float to_above) {
    float below = near_below(near, above);
    float to_below = near_below(near, to_above);
    float more = near.gap * (to_above - above) / (above * to_below);   // of the ratio over 1
    float s = more / (2.0 + more);
    float z = s * s;
    float by_s = 2.0 * s * (1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0))))));
    float whole = log(max(below * to_above, 1.0e-12) / max(above * to_below, 1.0e-12));
    return abs(more) < 0.5 ? by_s : whole;
}

// Less whole turns, of which light winds up many: 2 pi in two floats.
float near_turn(float psi) {
    float turns = floor(psi * 0.15915494309189533577 + 0.5);
    return (psi - turns * 6.28125) - turns * 1.9353071795864769e-3;
}
