// How numbers change from pixel to pixel, by the neighbours in the pixel's own block of 2 x 2: called for all four of a block, or for none. By
// compute for all of a group (stage/thread.glsl), whose threads hand them over in shared memory.
struct QuadStep {
    vec4 along;    // to the right
    vec4 across;   // upward
};

#ifdef BY_COMPUTE
#include "shared/thread.glsl"

shared vec4 quad_values[GROUP_THREADS];   // blocks of 2 x 2 are four threads in a row

QuadStep quad_step(vec4 here) {
    int thread = int(gl_LocalInvocationIndex);
    GROUP_WAITS();   // what was there before has been read
    quad_values[thread] = here;
    GROUP_WAITS();
    vec4 along = quad_values[thread | 1] - quad_values[thread & ~1];
    return QuadStep(along, quad_values[thread | 2] - quad_values[thread & ~2]);
}
#else
QuadStep quad_step(vec4 here) { return QuadStep(dFdx(here), dFdy(here)); }
#endif
