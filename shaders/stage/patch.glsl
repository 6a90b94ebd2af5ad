// Pixels that are drawn again with more rays, by compute: a thread a ray, in the place of stage/tile_point.glsl's points.
#include "shared/thread.glsl"
#include "stage/patch_place.glsl"
#include "stage/pixel.glsl"
#ifdef MATTER_LATTICE
#include "stage/lattice_tells.glsl"
#else
#ifdef DRAWS_TILES
#include "stage/tile_drawn.glsl"
#endif
#endif

layout(std430, binding = 1) readonly buffer PatchList { vec2 patch_listed[]; };   // column, and row from below, of the lowest left pixel of each
uniform int patch_count;

int patch_at(ivec2 pixel) { return pixel.y / patch_step() * patches_across() + pixel.x / patch_step(); }

ivec2 patch_tile(int number) { return ivec2(patch_listed[number]) / TILE_SIDE; }

// Does this stage draw it? A tile's program draws those that are in the tile.
bool patch_drawn(int number) {
    if (number >= patch_count) return false;
#ifdef MATTER_LATTICE
    return lattice_draws(patch_listed[number], patch_listed[number] + patch_pixels());
#else
#ifdef DRAWS_TILES
    return tile_drawn(tile_told(patch_tile(number)));
#else
    return true;
#endif
#endif
}

// Is there one for any thread of the group?
bool patch_in_group() {
    ivec2 corner = GROUP_SIDE * thread_tile();
    int along = max(GROUP_SIDE / patch_step(), 1);
    bool found = false;
    for (int i = 0; i < along * along; ++i) found = found || patch_drawn(patch_at(corner + patch_step() * ivec2(i % along, i / along)));
    return found;
}

// The thread's, or the first where it has none: whose neighbours hand their numbers over all the same.
int patch_of_thread() { return min(patch_at(thread_pixel()), patch_count - 1); }

// Does the thread draw a ray of one?
bool patch_has_thread() {
    ivec2 within = thread_pixel() % patch_step();
    return max(within.x, within.y) < int(patch_pixels() * sampling_rays()) && patch_drawn(patch_at(thread_pixel()));
}
