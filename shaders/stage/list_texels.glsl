// A ray of a list (stage/ray_list.glsl), and how what is found is stored: four texels of `listed_texture` above each other are its numbers.
#include "shared/fragment_at.glsl"
#include "shared/frame.glsl"
#include "stage/ray_list.glsl"

uniform sampler2D listed_texture;

ListedData fragment_listed() {
    frame = every_ray;
    ivec2 texel = ivec2(fragment_at()) * ivec2(1, 4);
    return listed_data(texelFetch(listed_texture, texel, 0), texelFetch(listed_texture, texel + ivec2(0, 1), 0),
                       texelFetch(listed_texture, texel + ivec2(0, 2), 0), texelFetch(listed_texture, texel + ivec2(0, 3), 0));
}

// fate + 8 count + 64 where there may be more crossings; sky direction
vec4 listed_fate_sky(ListedData data) {
    return vec4(data.end.fate + 8.0 * float(data.count) + (data.more ? 64.0 : 0.0), data.end.sky);
}

vec4 listed_g_delay_angle_hit(ListedData data) { return vec4(data.end.g, data.end.delay, data.end.angle, data.end.hit); }

#ifdef EFFECT_DISC
// x, y, climb; zeta at the angle that was asked for
vec4 listed_first_at(ListedData data) { return vec4(data.crossing_0.x, data.crossing_0.y, data.crossing_0.z, data.at); }
#endif
