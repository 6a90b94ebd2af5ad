// Rays of a list, one a fragment (stage/ray_list.glsl): four texels of `listed_texture` above each other are a ray's numbers.
#include "shared/frame.glsl"
#include "stage/ray_list.glsl"

uniform sampler2D listed_texture;

layout(location = 0) out vec4 fate_sky;        // fate + 8 count + 64 where there may be more crossings; sky direction
layout(location = 1) out vec4 g_delay_angle_hit;
#ifdef EFFECT_DISC
layout(location = 2) out vec4 crossing_0_at;   // x, y, climb; zeta at the angle that was asked for
layout(location = 3) out vec4 crossing_1;
layout(location = 4) out vec4 crossing_2;
layout(location = 5) out vec4 crossing_3;
#endif

void main() {
    frame = every_ray;
    ivec2 texel = ivec2(int(gl_FragCoord.x), 4 * int(gl_FragCoord.y));
    ListedData data = listed_data(texelFetch(listed_texture, texel, 0), texelFetch(listed_texture, texel + ivec2(0, 1), 0),
                                  texelFetch(listed_texture, texel + ivec2(0, 2), 0), texelFetch(listed_texture, texel + ivec2(0, 3), 0));
    fate_sky = vec4(data.end.fate + 8.0 * float(data.count) + (data.more ? 64.0 : 0.0), data.end.sky);
    g_delay_angle_hit = vec4(data.end.g, data.end.delay, data.end.angle, data.end.hit);
#ifdef EFFECT_DISC
    crossing_0_at = vec4(data.crossing_0.x, data.crossing_0.y, data.crossing_0.z, data.at);
    crossing_1 = data.crossing_1;
    crossing_2 = data.crossing_2;
    crossing_3 = data.crossing_3;
#endif
}
