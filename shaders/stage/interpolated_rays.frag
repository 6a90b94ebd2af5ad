// Where interpolated rays go, for tests: the sky's direction, and how they end.
#include "core/view.glsl"
#include "stage/pixel.glsl"
#include "stage/tile_rays.glsl"
#include "stage/tile_varyings.glsl"

out vec4 colour;

void main() {
    vec2 pixel = fragment_pixel(0);
    colour = vec4(tile_sky_at(tile_sky(), tile_place(pixel)), tile_escapes() ? RAY_ESCAPES : RAY_CAPTURED);
#ifdef BLOCK_PROJECTION
    if (beyond_view(pixel) > 0.0) colour = vec4(0.0);
#endif
}
