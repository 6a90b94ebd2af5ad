// Noise on a body: four octaves of value noise in space, so that nothing meets at a seam. p: place in grains; wide: the pixel's
// size in grains. Octaves finer than a pixel are at their mean.
#include "effect/expression.glsl"

float grain_noise(vec3 p, float wide) {
    float sum = 0.0;
    float weight = 0.5;
    float size = 1.0;
    for (int octave = 0; octave < 4; ++octave) {
        float seen = clamp(1.5 - wide * size, 0.0, 1.0);
        sum += weight * (seen > 0.0 ? mix(0.5, expression_noise(p * size), seen) : 0.5);
        weight *= 0.5;
        size *= 2.0;
    }
    return clamp(sum / 0.9375, 0.0, 1.0);
}
