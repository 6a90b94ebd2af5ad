// Rays of a list, one a fragment.
#include "stage/list_texels.glsl"

layout(location = 0) out vec4 fate_sky;
layout(location = 1) out vec4 g_delay_angle_hit;
#ifdef EFFECT_DISC
layout(location = 2) out vec4 crossing_0_at;
layout(location = 3) out vec4 crossing_1;
layout(location = 4) out vec4 crossing_2;
layout(location = 5) out vec4 crossing_3;
#endif

void main() {
    ListedData data = fragment_listed();
    fate_sky = listed_fate_sky(data);
    g_delay_angle_hit = listed_g_delay_angle_hit(data);
#ifdef EFFECT_DISC
    crossing_0_at = listed_first_at(data);
    crossing_1 = data.crossing_1;
    crossing_2 = data.crossing_2;
    crossing_3 = data.crossing_3;
#endif
}
