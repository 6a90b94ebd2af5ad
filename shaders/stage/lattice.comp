// A lattice of the light of matter by compute, a thread a texel: what stage/lattice.frag draws.
#include "shared/thread.glsl"
#include "stage/lattice_node.glsl"

layout(binding = 0, rgba32f) uniform writeonly image2D lattice_image;
uniform int drawn_from;   // from below: the rows that are drawn, up to but not including ...
uniform int drawn_to;     // ... this one

void main() {
    if (!thread_draws()) return;   // all of the group
    ivec2 texel = thread_pixel();
    vec4 light = lattice_light_of(texel);
    texel.x += (lattice_drawn_spread - 1) * TILE_SIDE * thread_tile().x;
    if (texel.y >= drawn_from && texel.y < drawn_to) imageStore(lattice_image, texel, light);   // none beyond the image
}
