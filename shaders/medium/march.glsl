// The march through matter, as every kind of path has it: what is summed up, and how long samples may be.
#include "medium/place.glsl"

#define MEDIUM_MOST_SAMPLES 4096
#define MEDIUM_LEAST 1.0e-3   // what of the light behind comes through where nothing more is looked for
#define MEDIUM_LONGEST 0.5    // of a ray's step, or rad

struct MediumSum {
    vec3 light;
    float through;   // what of the light behind comes through
};

// A sample more, `way` of the affine parameter long, along which source and absorption are taken as even.
MediumSum medium_add(MediumSum sum, MediumLight found, float way) {
    float depth = found.absorption * way;
    float dims = exp(-depth);
    float thick = (1.0 - dims) / max(depth, 1.0e-2);
    float thin = 1.0 - depth * (0.5 - depth * (1.0 / 6.0));   // of (1 - exp(-x))/x
    float share = depth < 1.0e-2 ? thin : thick;
    sum.light += (sum.through * share * way) * found.emission;
    sum.through *= dims;
    return sum;
}

// How long the next sample may be: `step` is what is short enough in the middle of the last one.
float medium_step(float step, float last, float least) { return max(max(step - 0.5 * last, 0.5 * step), least); }
