// What is known of a pixel's ray before any colour (docs/ray-data.md), as it is stored.
#include "stage/fragment_ray.glsl"
#include "stage/pixel_data.glsl"

struct RayTexels {
    vec4 fate_sky;              // fate, sky direction
    vec4 g_delay_angle_order;
    vec4 hit_place;             // object number, place
};

RayTexels ray_texels() {
    PixelData data = fragment_data(fragment_ray());
    RayTexels texels;
    texels.fate_sky = vec4(data.fate, data.sky);
    texels.g_delay_angle_order = vec4(data.g, data.delay, data.angle, floor(data.angle * 0.31830988618379067154));
    texels.hit_place = vec4(data.hit, data.place);
    return texels;
}
