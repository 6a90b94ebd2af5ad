// The picture's tiles, which are drawn as points, and what a tile's texel says in place of a set of bodies (core/bits.glsl).
#define TILE_INTERPOLATED -2.0   // the sky alone, its rays interpolated
#define TILE_SKY -1.0            // the sky alone: neither body nor disc
#define TILE_FULL -3.0           // the disc alone, at its first crossing; -4: at its second

// Those that are not drawn lie beyond the picture.
vec4 tile_position(ivec2 tile, ivec2 tiles, bool drawn) {
    vec2 middle = 2.0 * (vec2(tile) + 0.5) / vec2(tiles) - 1.0;
    return drawn ? vec4(middle, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
