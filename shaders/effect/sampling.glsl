// Several rays a pixel.
#include "shared/frame.glsl"

// Rays along a side of a pixel.
float sampling_rays() {
#ifdef NEEDS_SAMPLING
    return frame.sampling.z;
#else
    return 1.0;
#endif
}

// From one to the next, px.
float sampling_px() {
#ifdef NEEDS_SAMPLING
    return 1.0 / frame.sampling.z;
#else
    return 1.0;
#endif
}

// A side of what a ray stands for, over the distance between the rays of neighbouring fragments.
float sampling_share() {
#ifdef EFFECT_SAMPLES
    return sampling_px();
#else
    return 1.0;   // where edges have more rays each has a fragment of its own
#endif
}

#ifdef EFFECT_SAMPLES
// The rays that a fragment traces: number of the first, and how many.
int sampling_first() { return int(frame.sampling.x); }
int sampling_count() { return int(frame.sampling.y); }
#endif

#ifdef NEEDS_SAMPLING
// Fetches of the sky along the longer side of a ray's footprint, at most. A number that the compiler does not know: Mesa lays loops of known
// length out in full, and every ray then pays for the longest.
float sampling_fetches() { return frame.sampling.w; }
#endif
