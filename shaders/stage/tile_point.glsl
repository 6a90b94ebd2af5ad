// Tiles of the picture drawn as points, numbered by rows from below. Where pixels are drawn again with more rays a point is a patch of these rays, in
// a target of its own (render/ray_patches.h): a tile's program draws those that are in the tile.
#include "effect/sampling.glsl"
#include "generated/tiles"

#ifdef EFFECT_REFINE
#include "stage/patch_place.glsl"

layout(location = 0) in highp vec2 patch_pixel;   // column, and row from below, of its lowest left pixel
flat out highp vec2 patch_shift;                  // from a fragment to its ray's place in the picture, which is as fine as the rays lie
#endif

// The tile that a point is, or that its pixel is in.
ivec2 tile_of_point(int number, ivec2 tiles) {
#ifdef EFFECT_REFINE
    if (draws_patches()) return ivec2(patch_pixel) / TILE_SIDE;
#endif
    return ivec2(number % tiles.x, number / tiles.x);
}

// Those that are not drawn lie beyond the picture.
void place_point(int number, ivec2 tiles, bool drawn) {
    vec2 middle = 2.0 * (vec2(tile_of_point(number, tiles)) + 0.5) / vec2(tiles) - 1.0;
    gl_PointSize = float(TILE_SIDE);
#ifdef EFFECT_REFINE
    patch_shift = vec2(0.0);
    if (draws_patches()) {
        vec2 corner = patch_corner(number);
        gl_PointSize = patch_pixels() * sampling_rays();
        middle = (2.0 * corner + gl_PointSize) * (1.0 / float(PATCHES_SIDE)) - 1.0;
        patch_shift = patch_shift_of(number, patch_pixel);
    }
#endif
    gl_Position = drawn ? vec4(middle, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
