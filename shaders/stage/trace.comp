// The picture by compute, a thread a pixel: what stage/trace.frag draws. Tiles are the picture's own where it is drawn in tiles.
#include "shared/thread.glsl"
#include "stage/traced_pixel.glsl"
#ifdef COMPUTES_PATCHES
#include "stage/patch.glsl"
#else
#ifdef TILES_WITH_BODIES
uniform highp sampler2D tile_texture;   // stage/tile_texel.glsl
#endif
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
    ivec2 tile = thread_tile();
    bool draws = true;
    if (thread_in_patches()) {
        int number = patch_of_thread();
        patch_shift = patch_shift_of(number, patch_listed[number]);
        tile = patch_tile(number);
        draws = patch_has_thread();
    }
#ifdef TILES_WITH_BODIES
    tile_set = texelFetch(tile_texture, tile, 0);
#endif
    vec4 colour = traced_pixel();
    if (draws) put_pixel(thread_pixel(), colour);
}
#else
void main() {
#ifdef DRAWS_TILES
    if (!thread_draws()) return;   // all of the group
#ifdef TILES_WITH_BODIES
    tile_set = texelFetch(tile_texture, thread_tile(), 0);
#endif
#endif
    put_pixel(thread_pixel(), traced_pixel());
}
#endif
