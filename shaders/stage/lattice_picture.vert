// A tile of a picture with matter as a point, if it is one of those that a stage draws; or a pixel of it (stage/tile_point.glsl).
#include "shared/frame.glsl"
#include "stage/lattice_tells.glsl"
#include "stage/tile_point.glsl"

void main() {
    ivec2 tiles = ivec2(frame.image.xy * sampling_px() + float(TILE_SIDE) - 0.5) / TILE_SIDE;
    vec2 low = float(TILE_SIDE) * vec2(tile_of_point(gl_VertexID, tiles));
    vec2 high = low + float(TILE_SIDE);
#ifdef EFFECT_REFINE
    low = draws_patches() ? patch_pixel : low;
    high = draws_patches() ? patch_pixel + patch_pixels() : high;
#endif
    place_point(gl_VertexID, tiles, lattice_draws(low, high));
}
