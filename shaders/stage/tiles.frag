// What the picture's tiles may show, a texel a tile.
#include "stage/tile_texel.glsl"

out vec4 colour;

void main() { colour = tile_texel(ivec2(gl_FragCoord.xy)); }
