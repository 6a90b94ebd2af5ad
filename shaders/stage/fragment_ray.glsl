// The ray through a fragment's middle, and what is known of it.
#include "core/view.glsl"
#ifdef EFFECT_WARP
#include "effect/warp.glsl"
#endif
#include "shared/fragment_at.glsl"
#include "stage/pixel_data.glsl"

struct FragmentRay {
    vec2 pixel;   // picture_place() of the projection's own picture
    bool there;   // not beside a mesh
};

FragmentRay fragment_ray() {
    FragmentRay ray = FragmentRay(picture_place(fragment_at()), true);
#ifdef EFFECT_WARP
    WarpPlace seen = warp_place(ray.pixel);
    pixel_share = seen.share;
    ray = FragmentRay(seen.at, seen.light >= 0.0);
#endif
    return ray;
}

PixelData fragment_data(FragmentRay ray) {
    if (!ray.there) return no_ray();
    return pixel_data(ray.pixel);
}
