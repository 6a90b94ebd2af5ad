// A tile of the picture as a point, if it is one of those that are drawn: TILES_WITH_BODIES those that may show a body, else the others.
#include "generated/tiles"

uniform highp sampler2D tile_texture;   // stage/tiles.frag
#ifdef TILES_WITH_BODIES
flat out highp vec4 tile_set;           // of the bodies that it may show
#endif

void main() {
    ivec2 tiles = textureSize(tile_texture, 0);
    ivec2 tile = ivec2(gl_VertexID % tiles.x, gl_VertexID / tiles.x);
    vec4 set = texelFetch(tile_texture, tile, 0);
    bool bodies = max(max(set.x, set.y), max(set.z, set.w)) > 0.0;
#ifdef TILES_WITH_BODIES
    tile_set = set;
    bool drawn = bodies;
#else
    bool drawn = !bodies;
#endif
    vec2 middle = 2.0 * (vec2(tile) + 0.5) / vec2(tiles) - 1.0;
    gl_Position = drawn ? vec4(middle, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);   // beyond the picture: left out
    gl_PointSize = float(TILE_SIDE);
}
