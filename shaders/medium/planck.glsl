// Planck's law, by which what is in thermal equilibrium absorbs as it emits.

#define LOG2_E 1.44269504088896341
#define PLANCK_K 0.0479924307   // h/k, K a GHz

// A black body at a frequency (GHz): log2 of the temperature of the same light by Rayleigh and Jeans' law, K.
float log2_planck_temperature(float temperature, float frequency) {
    float t = max(temperature, 1.0);
    float x = PLANCK_K * frequency / t;
    float low = log2(1.0 - min(x, 0.02) * (0.5 - min(x, 0.02) * (1.0 / 12.0)));
    float high = log2(max(x, 1.0e-20)) - LOG2_E * x - log2(max(1.0 - exp(-x), 1.0e-3));
    return log2(t) + (x < 0.02 ? low : high);
}
