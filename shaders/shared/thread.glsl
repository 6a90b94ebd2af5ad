// By compute: a group of threads draws a tile of 8 x 8 pixels. Blocks of 2 x 2, and of 4 x 4, are threads in a row.
#define GROUP_SIDE 8
#define GROUP_THREADS 64

layout(local_size_x = GROUP_THREADS) in;

#ifdef COMPUTES_PATCHES
#include "shared/frame.glsl"

// Are pixels drawn again with more rays, in a target of their own (stage/patch.glsl)?
bool thread_in_patches() { return frame.sampling.z > 1.0; }   // rays along a side of a pixel
#endif

#ifdef DRAWS_TILES
#include "shared/tile_list.glsl"

uint thread_group() { return LIST_ACROSS * gl_WorkGroupID.y + gl_WorkGroupID.x; }

// Is there a tile for the group?
bool thread_draws() { return thread_group() < tile_list.tiles; }

ivec2 thread_tile() {
#ifdef COMPUTES_PATCHES
    if (thread_in_patches()) return ivec2(gl_WorkGroupID.xy);
#endif
    uint tile = tile_list.listed[thread_draws() ? thread_group() : 0u];
    return ivec2(int(tile & 65535u), int(tile >> 16));
}
#else
uniform int thread_row;   // of tiles, counted from below: the first that is drawn

ivec2 thread_tile() { return ivec2(gl_WorkGroupID.xy) + ivec2(0, thread_row); }
#endif

ivec2 thread_pixel() {
    int i = int(gl_LocalInvocationIndex);
    return GROUP_SIDE * thread_tile() + ivec2((i & 1) | (i >> 1 & 2) | (i >> 2 & 4), (i >> 1 & 1) | (i >> 2 & 2) | (i >> 3 & 4));
}
