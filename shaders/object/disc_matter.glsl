// How the disc's matter moves, how hot it is, and at what angle light leaves it: disc_matter_texture, cells of equal ln r.
#include "effect/black_body.glsl"
#ifdef SLOT_DISC_LIGHT
#include "generated/disc_light"
#endif
#include "path/disc"
#include "path/trace"
#include "shared/frame.glsl"

uniform highp sampler2D disc_matter_texture;
vec4 disc_matter_fetch(int i, int row) { return texelFetch(disc_matter_texture, ivec2(i, row), 0); }

#define DISC_MATTER_CELLS 1024

struct DiscMatter {
    float heat;   // log2 of the temperature over the hottest ring's
    float g;      // frequency in the camera over frequency in the matter
#ifdef NEEDS_POLARISATION
    vec3 u;       // velocity, as disc_g has it, over `scale`
    vec3 lapses;  // of the matter; of the light (object/disc_polarisation.glsl); scale
#endif
#ifdef SLOT_DISC_LIGHT
    float cosine; // between the light and the disc's normal, in the matter's frame
#endif
};

DiscMatter disc_matter(Trace trace, DiscCrossing crossing) {
    float x = clamp(log(crossing.r * frame.disc_heat.x) * frame.disc_heat.y, 0.0, float(DISC_MATTER_CELLS) - 0.001);
    int i = int(x);
    vec4 low = disc_matter_fetch(i, 0);
    vec4 high = disc_matter_fetch(i + 1, 0);
    vec4 matter = low + (x - float(i)) * (high - low);
    DiscMatter result;
    result.heat = matter.x;
    result.g = disc_g(trace, crossing, matter.yzw);
#ifdef NEEDS_POLARISATION
    vec4 lapses = mix(disc_matter_fetch(i, 1), disc_matter_fetch(i + 1, 1), x - float(i));
    result.u = matter.yzw;
    result.lapses = lapses.yzw;
#endif
#ifdef SLOT_DISC_LIGHT
    float parts = mix(disc_matter_fetch(i, 1).x, disc_matter_fetch(i + 1, 1).x, x - float(i));
    result.cosine = clamp(disc_cosine(trace, crossing, result.g) * parts, 0.0, 1.0);
#endif
    return result;
}

// What the heat of the disc looks like from here, linear light.
vec3 thermal_light(DiscMatter matter) {
    vec3 light = seen_black_body(frame.disc_heat.z + matter.heat, matter.g, frame.disc_heat.w);
#ifdef SLOT_DISC_LIGHT
    light *= disc_light(matter.cosine);
#endif
    return light;
}
