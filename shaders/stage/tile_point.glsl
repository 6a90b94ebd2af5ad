// Tiles of the picture drawn as points, numbered by rows from below. Where pixels are drawn again with more rays the points are the blocks
// that hold them, a half as wide, numbered in the same way.
#include "effect/sampling.glsl"
#include "generated/tiles"

// Points along a side of a tile.
int tile_points() {
#ifdef EFFECT_REFINE
    return sampling_rays() > 1.0 ? TILE_SIDE / BLOCK_SIDE : 1;
#else
    return 1;
#endif
}

ivec2 tile_point(int number, ivec2 tiles) {
    int across = tiles.x * tile_points();
    return ivec2(number % across, number / across);
}

// The tile that it is, or is in.
ivec2 tile_of_point(int number, ivec2 tiles) { return tile_point(number, tiles) / tile_points(); }

// Those that are not drawn lie beyond the picture.
vec4 tile_position(int number, ivec2 tiles, bool drawn) {
    vec2 middle = 2.0 * (vec2(tile_point(number, tiles)) + 0.5) / vec2(tiles * tile_points()) - 1.0;
    return drawn ? vec4(middle, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}

float tile_point_size() { return float(TILE_SIDE / tile_points()); }
