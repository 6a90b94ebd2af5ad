// Of the first thing that each pixel's ray meets (docs/layers.md): its depth, and the frequency of light from the disc's matter or from a body that
// shines by its heat.
#ifdef NEEDS_LIGHT_TIMES
#ifndef EFFECT_SIDES
#ifndef EFFECT_ZOOM
#define KNOWS_DEPTH   // not through a throat, nor where a zoom leaves windings out
#include "path/depth"
#ifdef SLOT_MEDIUM
#define SHOWS_MEDIUM
#include "path/medium"
#endif
#endif
#endif
#endif
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif
#ifdef EFFECT_GLOW
#include "generated/bodies_shift"
#endif
#include "path/trace"
#include "stage/fragment_ray.glsl"
#include "stage/pixel_data.glsl"

layout(location = 0) out vec4 depth_g;   // affine parameter, camera frequency over that where it left; 0 where there is none
#ifdef SLOT_MEDIUM
layout(location = 1) out vec4 medium_mean;   // of matter along the ray: where its light comes from in the mean, r_s, and the affine parameter there
#endif

#ifdef EFFECT_THERMAL_DISC
// Of the crossing that the ray data say.
float matter_g(Trace trace, float along) {
    float g = 0.0;
    for (DiscWalk walk = disc_walk(trace); walk.more && g == 0.0; walk = disc_next(trace, walk)) {
        DiscCrossing crossing = disc_walk_crossing(trace, walk);
        if (crossing.hit && crossing.phi >= along) g = disc_matter(trace, crossing).g;
    }
    return g;
}
#endif

#ifdef SHOWS_MEDIUM
// The mean is by light that reaches the camera; of matter that only hides, by how much. In front of what ends the ray.
vec4 medium_shown(vec2 pixel, Trace trace, PixelData data) {
    float until = 1.0e30;
#ifdef NEEDS_PLACE
    until = data.until;
#endif
#ifdef EFFECT_DISC
    if (data.hit == 1.0 && frame.disc_surface.x >= 1.0) until = min(until, data.along);
#endif
    MediumSum sum = medium_to(trace, medium_walk(trace, pixel), until).sum;
    if (sum.weight.x > 0.0) return medium_depth(pixel, trace, sum.moment.x / sum.weight.x);
    return sum.weight.y > 0.0 ? medium_depth(pixel, trace, sum.moment.y / sum.weight.y) : vec4(0.0);
}
#endif

void main() {
    FragmentRay ray = fragment_ray();
    PixelData data = fragment_data(ray);
    Trace trace = trace_pixel(ray.pixel);
    depth_g = vec4(0.0);
#ifdef SLOT_MEDIUM
    medium_mean = vec4(0.0);
#endif
#ifdef SHOWS_MEDIUM
    if (data.fate != 3.0) medium_mean = medium_shown(ray.pixel, trace, data);
#endif
#ifdef KNOWS_DEPTH
    if (data.hit != 0.0) depth_g.x = affine_depth(ray.pixel, trace, data.along);
#endif
#ifdef EFFECT_THERMAL_DISC
    if (data.hit == 1.0) depth_g.y = matter_g(trace, data.along);
#endif
#ifdef EFFECT_GLOW
    if (data.hit > 1.0) depth_g.y = solid_g(trace, solid_hit(trace, 0.0));
#endif
}
