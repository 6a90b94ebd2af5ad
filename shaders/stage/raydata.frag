// The ray data of a frame.
#include "stage/ray_texels.glsl"

layout(location = 0) out vec4 fate_sky;
layout(location = 1) out vec4 g_delay_angle_order;
layout(location = 2) out vec4 hit_place;

void main() {
    RayTexels texels = ray_texels();
    fate_sky = texels.fate_sky;
    g_delay_angle_order = texels.g_delay_angle_order;
    hit_place = texels.hit_place;
}
