// Where interpolated rays go, for tests: the sky's direction, and how they end; of tiles of disc where they cross it (x, y, delay), and 1 more than the
// number of that crossing.
#include "core/view.glsl"
#include "stage/pixel.glsl"
#include "stage/tile_rays.glsl"
#include "stage/tile_varyings.glsl"

out vec4 colour;

void main() {
    vec2 pixel = fragment_pixel(0);
#ifdef INTERPOLATED_DISC
    colour = vec4(polynomial_at(tile_disc(), tile_place(pixel)).xyz, 1.0 + tile_told.x);
#else
    colour = vec4(polynomial_at(tile_sky(), tile_place(pixel)).xyz, tile_escapes() ? RAY_ESCAPES : RAY_CAPTURED);
#endif
#ifdef BLOCK_PROJECTION
    if (beyond_view(pixel) > 0.0) colour = vec4(0.0);
#endif
}
