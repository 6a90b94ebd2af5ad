// Where more rays are worth their cost: pixels whose light differs much from a neighbour's as it is displayed, or whose rays went another way.
#include "shared/frame.glsl"

#define EDGE_LEAST 0.1    // of black to white
#define EDGE_HARD 0.375    // likewise
#define EDGE_SCALE 0.125   // of light, beside halves of ways: half floats keep both

#ifdef BLOCK_MEDIUM
// Of a picture that is a flux: what is for the eye changes no pixel's rays.
float edge_exposure() { return frame.medium_bound.w > 0.0 ? frame.medium_bound.w : frame.image.w; }
#else
float edge_exposure() { return frame.image.w; }
#endif

// The brightest channel about as the display has it: a shoulder, and the square root for its encoding. 0 ... 1
float edge_shown(vec3 light) {
    float most = max(max(light.r, max(light.g, light.b)) * edge_exposure(), 0.0);
    return sqrt(most / (most + 0.6));
}

// way: a small whole number; of neighbours with different ones something may lie between that neither met.
float edge_value(vec3 light, float way) { return EDGE_SCALE * edge_shown(light) + 0.5 * way; }

// Of the difference of two values: 0 neither, 1 or 2 the light, little or much of it, 3 the way; in thirds.
float edge_kind(float off) {
    float light = off < EDGE_SCALE * EDGE_LEAST ? 0.0 : off < EDGE_SCALE * EDGE_HARD ? 1.0 : 2.0;
    return (off < 0.25 ? light : 3.0) * (1.0 / 3.0);
}
