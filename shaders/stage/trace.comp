// The picture by compute, a thread a pixel: what stage/trace.frag draws. Tiles are the picture's own where it is drawn in tiles.
#include "shared/thread.glsl"
#include "stage/traced_pixel.glsl"
#ifdef COMPUTES_PATCHES
#include "stage/patch.glsl"
#endif
#ifdef TILES_WITH_BODIES
#include "stage/tile_drawn.glsl"
#endif
#ifdef TILES_OF_FULL_DISC
#include "stage/tile_drawn.glsl"
#endif

// The picture's tile that the group is in.
#ifdef DRAWS_TILES
#include "generated/tiles"
#define TOLD_TILE (thread_tile() / TILE_GROUPS)
#else
#define TOLD_TILE thread_tile()
#endif

layout(binding = 0, PICTURE_FORMAT) uniform image2D picture_image;
uniform int drawn_from;       // from below: the rows that are drawn, up to but not including ...
uniform int drawn_to;         // ... this one
uniform float layer_share;    // what is drawn counts so much: in the place of what is there, or added to it (PICTURE_ADDS)

void put_pixel(ivec2 pixel, vec4 colour) {
    if (pixel.x >= imageSize(picture_image).x || pixel.y < drawn_from || pixel.y >= drawn_to) return;
    colour *= layer_share;
    if (PICTURE_ADDS) colour += imageLoad(picture_image, pixel);
    imageStore(picture_image, pixel, colour);
}

// What a tile tells its rays.
void begin_tile(ivec2 tile) {
#ifdef TILES_WITH_BODIES
    tile_set = tile_told(tile);
#endif
#ifdef TILES_OF_FULL_DISC
    tile_number = tile_crossing(tile_told(tile));
#endif
}

#ifdef COMPUTES_PATCHES
// Whether there is something to draw; the same for all of the group.
bool begin_group() {
    if (thread_in_patches()) return patch_in_group();
#ifdef DRAWS_TILES
    return thread_draws();
#else
    return true;
#endif
}

void main() {
    if (!begin_group()) return;
    ivec2 tile = TOLD_TILE;
    bool draws = true;
    if (thread_in_patches()) {
        int number = patch_of_thread();
        patch_shift = patch_shift_of(number, patch_listed[number]);
        tile = patch_tile(number);
        draws = patch_has_thread();
    }
    begin_tile(tile);
    vec4 colour = traced_pixel();
    if (draws) put_pixel(thread_pixel(), colour);
}
#else
void main() {
#ifdef DRAWS_TILES
    if (!thread_draws()) return;   // all of the group
#endif
    begin_tile(TOLD_TILE);
    put_pixel(thread_pixel(), traced_pixel());
}
#endif
