// Where the rays of the picture's tiles go, by compute, a thread each: what stage/rays.frag draws.
#include "shared/thread.glsl"
#include "stage/corner_ray.glsl"

layout(binding = 0, rgba32f) uniform writeonly image2D ray_image;
#ifdef EFFECT_DISC
layout(binding = 1, rgba32f) uniform writeonly image2D places_image;
#endif
#ifdef CROSSINGS_TOLD
layout(binding = 2, rgba32f) uniform writeonly image2D moves_image;
#endif

void main() {
    CornerRay found = corner_ray(thread_pixel());
    imageStore(ray_image, thread_pixel(), found.ray);   // none beyond the image
#ifdef EFFECT_DISC
    imageStore(places_image, thread_pixel(), found.places);
#endif
#ifdef CROSSINGS_TOLD
    imageStore(moves_image, thread_pixel(), found.moves);
#endif
}
