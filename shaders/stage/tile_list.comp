// Lists the tiles that a stage draws, those of groups of threads; a thread a tile.
#include "shared/tile_list.glsl"
#ifdef DRAWS_LATTICE
#include "stage/lattice_tile.glsl"
#else
#ifdef MATTER_LATTICE
#include "stage/lattice_tells.glsl"
#else
#include "stage/tile_drawn.glsl"
#endif
#endif

layout(local_size_x = 64) in;

uniform int tiles_across;   // in a row
uniform int tile_from;      // of the picture's, counted in rows from its lower left one: those that are asked for, up to ...
uniform int tile_to;        // ... but not including this
uniform int tile_groups;    // of those that are listed, along a side of one of the picture's tiles

bool draws_tile(ivec2 tile) {
#ifdef DRAWS_LATTICE
    return lattice_tile_drawn(tile);
#else
#ifdef MATTER_LATTICE
    vec2 low = float(TILE_SIDE) * vec2(tile);
    return lattice_draws(low, low + float(TILE_SIDE));
#else
    return tile_drawn(tile_told(tile / tile_groups));
#endif
#endif
}

void main() {
    int i = tile_from + int(gl_GlobalInvocationID.x);
    ivec2 tile = ivec2(i % tiles_across, i / tiles_across);
    if (i >= tile_to || !draws_tile(tile)) return;
    uint place = atomicAdd(tile_list.tiles, 1u);
    tile_list.listed[place] = uint(tile.x) | uint(tile.y) << 16;
    atomicMax(tile_list.groups_across, min(place + 1u, LIST_ACROSS));
    atomicMax(tile_list.groups_up, place / LIST_ACROSS + 1u);
}
