// Thermal synchrotron radiation of relativistic electrons, in units of 1e-20 erg/(s Hz sr) an electron a cm^3.
// In a field of one direction: Leung, Gammie and Noble 2011 (ApJ 737, 21); mean over all directions: Mahadevan, Narayan and Yi
// 1996 (ApJ 465, 327), for relativistic electrons. COLDEST_K and FIELD_DIRECTED: generated/medium_matter.

#include "medium/matter.glsl"

#define ELECTRON_K 5.92989658e9         // m c^2/k
#define GYRO_GHZ 2.79924899e-3          // e/(2 pi m c), GHz a gauss
#define PLANCK_K 0.0479924307           // h/k, K a GHz

// K_2(x) exp(x) x^2/2 for x = 1/theta below 12, to 4e-6.
float bessel_part(float x) {
    float top = 1.0 + x * (3.11904059 + x * (3.7342093 + x * (2.04092927 + x * 0.43933163)));
    return sqrt(top / (1.0 + 1.11883164 * x));
}

// A black body at a frequency (GHz): temperature of the same light by Rayleigh and Jeans' law, K.
float planck_temperature(float temperature, float frequency) {
    float t = max(temperature, 1.0);
    float x = min(PLANCK_K * frequency / t, 80.0);
    float low = 1.0 - x * (0.5 - x * (1.0 / 12.0));
    float high = x / max(exp(x) - 1.0, 1.0e-3);
    return t * (x < 0.02 ? low : high);
}

// way: of the light, where the matter rests; frequency in GHz.
float synchrotron(MediumMatter matter, vec3 way, float frequency) {
    float theta = clamp(matter.temperature, COLDEST_K, 1.0e14) / ELECTRON_K;
    float gyro = GYRO_GHZ * clamp(matter.field, 1.0e-6, 1.0e9);
    float bessel = 2.0 * theta * theta * bessel_part(1.0 / theta);   // K_2(1/theta) exp(1/theta)
#ifdef FIELD_DIRECTED
    float sine = clamp(length(cross(way, matter.field_way)), 1.0e-3, 1.0);
    float scale = (2.0 / 9.0) * gyro * theta * theta * sine;
    float x = frequency / scale;
    float third = exp2(log2(x) * (1.0 / 3.0));
    float root = sqrt(x) + 1.88774862536 * sqrt(third);   // 2^(11/12)
    float value = 1.13968 * scale / bessel * root * root * exp(1.0 / theta - third);
#else
    float x = (2.0 / 3.0) * frequency / (gyro * theta * theta);
    float third = exp2(log2(x) * (1.0 / 3.0));
    float sixth = sqrt(third);
    float quarter = sqrt(sqrt(x));
    float value = 0.444305 * frequency / bessel * 4.0505 / sixth * (1.0 + 0.4 / quarter + 0.5316 / (quarter * quarter)) *
                  exp(1.0 / theta - 1.8899 * third);
#endif
    return matter.temperature < COLDEST_K || matter.field <= 0.0 ? 0.0 : value;
}
