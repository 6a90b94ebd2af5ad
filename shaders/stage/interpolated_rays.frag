// Where interpolated rays go, for tests: the sky's direction, and how they end.
#include "stage/pixel.glsl"
#include "stage/tile_rays.glsl"
#include "stage/tile_varyings.glsl"

out vec4 colour;

void main() { colour = vec4(tile_sky_at(tile_sky(), tile_place(fragment_pixel(0))), tile_escapes() ? RAY_ESCAPES : RAY_CAPTURED); }
