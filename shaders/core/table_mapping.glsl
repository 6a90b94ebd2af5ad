// Where a ray lies in the deflection table, and back: forward and inverse mapping of (q, zeta0), GLSL and C++.
//
// The slides' indices (q, zeta0) enter as k = q / q_crit and as the angle of the camera on the ray:
//   V(zeta) = A zeta^2 = q_crit^2 sin^2(chi)   (chi: 0 at infinity, pi/2 on the photon sphere, pi at the horizon)
//   V(zeta0) = q^2 sin^2(alpha)                (alpha: static-frame angle between view direction and outward radial)
//
// Branches: TURNING (k < 1: the ray turns at sin(alpha) = 1; one branch for each side of the photon sphere), coordinates
//   x = 1 - sqrt(1 - k), y = alpha / pi;
// THROUGH (k > 1: the ray passes the photon sphere), coordinates x = sqrt(1 - 1/k), y = chi / pi.
//
// Before (phi over q at zeta0 = 0, uniform in q): a logarithmic pole at q_crit and a square root at every turning point.
//
//   phi |             :             after (remainder R over x, analytic logarithm removed, see deflection_table.h):
//       |             ::
//       |            : :             R |        . - ' ' ' ' .
//       |         . '   ' .            |   . '              ' .
//       | . . - '           ' - . .    | '                      '
//       +-------------|-----------q    +--------------------------x
//                   q_crit             0 (q = 0)                  1 (q = q_crit)

// 1 - k given, not k: rays close to the critical one keep their digits. [0,1] -> [0,1]
float turning_x_from_one_minus_k(float one_minus_k) { return 1.0 - sqrt(one_minus_k); }
float turning_one_minus_k_from_x(float x) { return (1.0 - x) * (1.0 - x); }

// k - 1 given. [0, infinity) -> [0, 1)
float through_x_from_k_minus_one(float k_minus_one) { return sqrt(k_minus_one / (1.0 + k_minus_one)); }
float through_k_minus_one_from_x(float x) { return x * x / ((1.0 - x) * (1.0 + x)); }

// The angles alpha and chi run uniformly. [0, pi] -> [0, 1]
float table_y_from_angle(float angle) { return angle * 0.31830988618379067154; }
float table_angle_from_y(float y) { return y * 3.14159265358979323846; }
