// A ray's light by what the lattice tells of matter, or by the ray itself.
#include "core/view.glsl"
#include "effect/sampling.glsl"
#include "path/ray_way"
#include "stage/lattice.glsl"
#include "stage/ray_light.glsl"

#ifdef LATTICE_BEFORE_SKY
vec4 light_behind(LatticeLight matter, vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    RaySight sight;
    sight.light = matter.light;
    sight.through = matter.through;
    sight = with_painted(with_sky(sight, trace), trace);
    return vec4(sight.light, sight_rest(sight, trace));
}
#else
#ifdef EFFECT_POINT_STARS
vec4 light_behind(LatticeLight matter, vec2 pixel) { return vec4(matter.light, matter.through); }
#else
vec4 light_behind(LatticeLight matter, vec2 pixel) { return vec4(matter.light, open_way(matter.escapes)); }
#endif
#endif

#define LATTICE_WAY 0.1   // of a way, for effect/edge.glsl: as light that differs much. At the shadow's edge 16 rays are as good as 36 where only matter is seen

#ifdef EFFECT_POINT_STARS
vec4 with_way(vec4 light) { return light; }
#else
vec4 with_way(vec4 light) { return vec4(light.rgb, LATTICE_WAY * light.a); }
#endif

#ifdef BY_COMPUTE
#define LATTICE_BOTH GROUP_TOGETHER   // rays about a rotating hole ask their neighbours, for which all of a group wait
#else
#define LATTICE_BOTH false   // a block of 2 x 2 fragments lies in one cell
#endif

vec4 pixel_light(vec2 pixel) {
    LatticeLight matter = lattice_light(picture_fragment(pixel) * sampling_px());
#ifdef LATTICE_TOLD
    vec4 light = light_behind(matter, pixel);
#else
    vec4 light = vec4(0.0);
    if (LATTICE_BOTH || !matter.known) light = ray_light(pixel);
    if (LATTICE_BOTH || matter.known) {
        vec4 told = light_behind(matter, pixel);
        light = matter.known ? told : light;
    }
#endif
    return with_way(light);
}
