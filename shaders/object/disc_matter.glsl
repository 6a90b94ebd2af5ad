// How the disc's matter moves and how hot it is: disc_matter_texture, cells of equal ln r.
#include "effect/black_body.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/frame.glsl"

uniform highp sampler2D disc_matter_texture;
vec4 disc_matter_fetch(int i) { return texelFetch(disc_matter_texture, ivec2(i, 0), 0); }

#define DISC_MATTER_CELLS 1024

struct DiscMatter {
    float heat;   // log2 of the temperature over the hottest ring's
    float g;      // frequency in the camera over frequency in the matter
};

DiscMatter disc_matter(Trace trace, DiscCrossing crossing) {
    float x = clamp(log(crossing.r * frame.disc_heat.x) * frame.disc_heat.y, 0.0, float(DISC_MATTER_CELLS) - 0.001);
    int i = int(x);
    vec4 low = disc_matter_fetch(i);
    vec4 high = disc_matter_fetch(i + 1);
    vec4 matter = low + (x - float(i)) * (high - low);
    DiscMatter result;
    result.heat = matter.x;
    result.g = disc_g(trace, crossing, matter.yzw);
    return result;
}

// What the heat of the disc looks like from here, linear light.
vec3 thermal_light(DiscMatter matter) {
    return seen_black_body(frame.disc_heat.z + matter.heat, matter.g, frame.disc_heat.w);
}
