// Of the first thing that each pixel's ray meets (docs/layers.md): its depth, and the frequency of light from the disc's matter.
#ifdef NEEDS_LIGHT_TIMES
#ifndef EFFECT_SIDES
#ifndef EFFECT_ZOOM
#define KNOWS_DEPTH   // not through a throat, nor where a zoom leaves windings out
#include "path/depth"
#endif
#endif
#endif
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif
#include "path/trace"
#include "stage/fragment_ray.glsl"
#include "stage/pixel_data.glsl"

out vec4 depth_g;   // affine parameter, camera frequency over that in the matter; 0 where there is none

#ifdef EFFECT_THERMAL_DISC
// Of the crossing that the ray data say.
float matter_g(Trace trace, float along) {
    float g = 0.0;
    for (DiscWalk walk = disc_walk(trace); walk.more && g == 0.0; walk = disc_walk_on(trace, walk)) {
        DiscCrossing crossing = disc_walk_crossing(trace, walk);
        if (crossing.hit && crossing.phi >= along) g = disc_matter(trace, crossing).g;
    }
    return g;
}
#endif

void main() {
    FragmentRay ray = fragment_ray();
    PixelData data = fragment_data(ray);
    Trace trace = trace_pixel(ray.pixel);
    depth_g = vec4(0.0);
#ifdef KNOWS_DEPTH
    if (data.hit != 0.0) depth_g.x = affine_depth(ray.pixel, trace, data.along);
#endif
#ifdef EFFECT_THERMAL_DISC
    if (data.hit == 1.0) depth_g.y = matter_g(trace, data.along);
#endif
}
