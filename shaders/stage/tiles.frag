// Which bodies a tile of the picture may show, a texel a tile: bits (core/bits.glsl).
#include "core/bits.glsl"
#include "generated/tiles"
#include "path/tile"
#include "shared/frame.glsl"

out vec4 colour;

void main() {
    vec2 middle = gl_FragCoord.xy * float(TILE_SIDE) - 0.5 * frame.image.xy;
    colour = texel_of(tile_bodies(middle));
}
