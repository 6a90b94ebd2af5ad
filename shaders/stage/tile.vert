// A tile of the picture as a point, if it is one of those that a stage draws.
#include "stage/tile_drawn.glsl"
#include "stage/tile_point.glsl"

#ifdef TILES_WITH_BODIES
flat out highp vec4 tile_set;           // of the bodies that it may show
#endif
#ifdef TILES_OF_FULL_DISC
flat out highp float tile_number;       // of the crossing at which it shows the disc
#endif

void main() {
    ivec2 tiles = textureSize(tile_texture, 0);
    ivec2 tile = tile_of_point(gl_VertexID, tiles);
    vec4 set = tile_told(tile);
#ifdef TILES_WITH_BODIES
    tile_set = set;
#endif
#ifdef TILES_OF_FULL_DISC
    tile_number = tile_crossing(set);
#endif
    place_point(gl_VertexID, tiles, tile_drawn(set));
}
