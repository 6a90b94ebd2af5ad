// Which tiles of the picture may show a body, a texel a tile: 1 where one may.
#include "generated/tiles"
#include "path/tile"
#include "shared/frame.glsl"

out vec4 colour;

void main() {
    vec2 middle = gl_FragCoord.xy * float(TILE_SIDE) - 0.5 * frame.image.xy;
    colour = vec4(tile_shows_body(middle) ? 1.0 : 0.0);
}
