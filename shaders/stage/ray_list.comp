// Rays of a list by compute, one a thread: what stage/ray_list.frag draws.
#include "shared/thread.glsl"
#include "stage/list_texels.glsl"

layout(binding = 0, rgba32f) uniform writeonly image2D fate_sky;
layout(binding = 1, rgba32f) uniform writeonly image2D g_delay_angle_hit;
#ifdef EFFECT_DISC
layout(binding = 2, rgba32f) uniform writeonly image2D crossing_0_at;
layout(binding = 3, rgba32f) uniform writeonly image2D crossing_1;
layout(binding = 4, rgba32f) uniform writeonly image2D crossing_2;
layout(binding = 5, rgba32f) uniform writeonly image2D crossing_3;
#endif

void main() {
    ListedData data = fragment_listed();
    imageStore(fate_sky, thread_pixel(), listed_fate_sky(data));   // none beyond the image
    imageStore(g_delay_angle_hit, thread_pixel(), listed_g_delay_angle_hit(data));
#ifdef EFFECT_DISC
    imageStore(crossing_0_at, thread_pixel(), listed_first_at(data));
    imageStore(crossing_1, thread_pixel(), data.crossing_1);
    imageStore(crossing_2, thread_pixel(), data.crossing_2);
    imageStore(crossing_3, thread_pixel(), data.crossing_3);
#endif
}
