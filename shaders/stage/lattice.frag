// A lattice of the light of matter.
#include "stage/lattice_node.glsl"

out vec4 colour;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    texel.x = texel.x / (TILE_SIDE * lattice_drawn_spread) * TILE_SIDE + texel.x % TILE_SIDE;
    colour = lattice_light_of(texel);
}
