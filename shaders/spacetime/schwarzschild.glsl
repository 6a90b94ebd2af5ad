// Schwarzschild: V = zeta^2 (1 - zeta).
float half_v_slope(float zeta) { return zeta * (1.0 - 1.5 * zeta); }
