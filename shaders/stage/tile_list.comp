// Lists the tiles that a stage draws, by their texels; a thread a tile.
#include "shared/tile_list.glsl"
#include "stage/tile_drawn.glsl"

layout(local_size_x = 64) in;

uniform highp sampler2D tile_texture;   // stage/tiles.frag
uniform int tile_from;                  // of the picture's, counted in rows from its lower left one: those that are asked for, up to ...
uniform int tile_to;                    // ... but not including this

void main() {
    int i = tile_from + int(gl_GlobalInvocationID.x);
    int across = textureSize(tile_texture, 0).x;
    ivec2 tile = ivec2(i % across, i / across);
    if (i >= tile_to || !tile_drawn(texelFetch(tile_texture, tile, 0))) return;
    uint place = atomicAdd(tile_list.tiles, 1u);
    tile_list.listed[place] = uint(tile.x) | uint(tile.y) << 16;
    atomicMax(tile_list.groups_across, min(place + 1u, LIST_ACROSS));
    atomicMax(tile_list.groups_up, place / LIST_ACROSS + 1u);
}
