// Of a lattice's texels in tiles, numbered as if these lay side by side: does a stage draw a tile?
#include "generated/tiles"
#include "stage/lattice_tells.glsl"

uniform int lattice_drawn;    // as stage/lattice_node.glsl
uniform int lattice_drawn_texels;
uniform int lattice_drawn_spread;
uniform int lattice_across;   // texels

// Of a row the last ones are none where tiles lie apart.
bool lattice_tile_drawn(ivec2 tile) {
    if (tile.x * lattice_drawn_spread >= (lattice_across + TILE_SIDE - 1) / TILE_SIDE) return false;
    vec2 size = vec2(TILE_SIDE / lattice_drawn_texels, TILE_SIDE);   // nodes
    vec2 low = float(lattice_drawn) * (vec2(tile) * size - 1.0);
    return lattice_draws(low, low + float(lattice_drawn) * size);
}
