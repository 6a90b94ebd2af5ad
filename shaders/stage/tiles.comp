// What the picture's tiles may show, by compute, a thread a tile: what stage/tiles.frag draws.
#include "shared/thread.glsl"
#include "stage/tile_texel.glsl"

layout(binding = 0, rgba32f) uniform writeonly image2D tile_image;

void main() { imageStore(tile_image, thread_pixel(), tile_texel(thread_pixel())); }   // none beyond the image
