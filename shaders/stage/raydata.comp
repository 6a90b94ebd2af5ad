// The ray data of a frame by compute: what stage/raydata.frag draws.
#include "shared/thread.glsl"
#include "stage/ray_texels.glsl"

layout(binding = 0, rgba32f) uniform writeonly image2D fate_sky;
layout(binding = 1, rgba32f) uniform writeonly image2D g_delay_angle_order;
layout(binding = 2, rgba32f) uniform writeonly image2D hit_place;

void main() {
    RayTexels texels = ray_texels();
    imageStore(fate_sky, thread_pixel(), texels.fate_sky);   // none beyond the image
    imageStore(g_delay_angle_order, thread_pixel(), texels.g_delay_angle_order);
    imageStore(hit_place, thread_pixel(), texels.hit_place);
}
