// The ray data of a frame: what is known of each pixel's ray before any colour (docs/ray-data.md).
#include "stage/fragment_ray.glsl"
#include "stage/pixel_data.glsl"

layout(location = 0) out vec4 fate_sky;          // fate, sky direction
layout(location = 1) out vec4 g_delay_angle_order;
layout(location = 2) out vec4 hit_place;         // object number, place

void main() {
    PixelData data = fragment_data(fragment_ray());
    fate_sky = vec4(data.fate, data.sky);
    g_delay_angle_order = vec4(data.g, data.delay, data.angle, floor(data.angle * 0.31830988618379067154));
    hit_place = vec4(data.hit, data.place);
}
