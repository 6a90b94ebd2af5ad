// Constants of electrons, and the Bessel function of their thermal distribution.

#define ELECTRON_K 5.92989658e9         // m c^2/k
#define GYRO_GHZ 2.79924899e-3          // e/(2 pi m c), GHz a gauss

// K_2(x) exp(x) x^2/2 for x = 1/theta below 12, to 4e-6.
float bessel_part(float x) {
    float top = 1.0 + x * (3.11904059 + x * (3.7342093 + x * (2.04092927 + x * 0.43933163)));
    return sqrt(top / (1.0 + 1.11883164 * x));
}
