// Is a tile of the picture, by its texel (stage/tile_texel.glsl), one of those that a stage draws?
#include "stage/tile_kind.glsl"

uniform highp sampler2D tile_texture;   // stage/tile_texel.glsl

vec4 tile_told(ivec2 tile) { return texelFetch(tile_texture, tile, 0); }

float tile_most(vec4 set) { return max(max(set.x, set.y), max(set.z, set.w)); }

bool tile_drawn(vec4 set) {
#ifdef TILES_WITH_BODIES
    return tile_most(set) > 0.0;
#endif
#ifdef TILES_OF_SKY
    return tile_most(set) == TILE_SKY;
#endif
#ifdef TILES_OF_FULL_DISC
    return tile_most(set) <= TILE_FULL;
#endif
#ifdef TILES_OF_THE_REST
    return tile_most(set) == 0.0;
#endif
}

#ifdef TILES_OF_FULL_DISC
// Which crossing shows the disc.
float tile_crossing(vec4 set) { return TILE_FULL - tile_most(set); }
#endif
