// A tile of a lattice's texels as a point, numbered by rows from below, if it is one of those that a stage draws.
#include "generated/tiles"
#include "stage/lattice_tells.glsl"

uniform int lattice_drawn;    // as stage/lattice.frag
uniform int lattice_drawn_texels;
uniform int lattice_drawn_spread;
uniform int lattice_across;   // texels
uniform int lattice_up;

void main() {
    ivec2 tiles = (ivec2(lattice_across, lattice_up) + TILE_SIDE - 1) / TILE_SIDE;
    ivec2 tile = ivec2(gl_VertexID % tiles.x, gl_VertexID / tiles.x);   // of a row the last ones are none where tiles lie apart
    vec2 size = vec2(TILE_SIDE / lattice_drawn_texels, TILE_SIDE);   // nodes
    vec2 low = float(lattice_drawn) * (vec2(tile) * size - 1.0);
    bool drawn = false;
    if (tile.x * lattice_drawn_spread < tiles.x) drawn = lattice_draws(low, low + float(lattice_drawn) * size);
    vec2 middle = 2.0 * (vec2(tile * ivec2(lattice_drawn_spread, 1)) + 0.5) / vec2(tiles) - 1.0;
    gl_Position = vec4(drawn ? middle : vec2(2.0), 0.0, 1.0);
    gl_PointSize = float(TILE_SIDE);
}
