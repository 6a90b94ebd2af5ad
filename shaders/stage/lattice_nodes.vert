// A tile of a lattice's texels as a point, numbered by rows from below, if it is one of those that a stage draws.
#include "stage/lattice_tile.glsl"

uniform int lattice_up;   // texels

void main() {
    ivec2 tiles = (ivec2(lattice_across, lattice_up) + TILE_SIDE - 1) / TILE_SIDE;
    ivec2 tile = ivec2(gl_VertexID % tiles.x, gl_VertexID / tiles.x);
    vec2 middle = 2.0 * (vec2(tile * ivec2(lattice_drawn_spread, 1)) + 0.5) / vec2(tiles) - 1.0;
    gl_Position = vec4(lattice_tile_drawn(tile) ? middle : vec2(2.0), 0.0, 1.0);
    gl_PointSize = float(TILE_SIDE);
}
