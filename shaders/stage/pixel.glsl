// Where a fragment's rays go, and what becomes of their light.
#ifdef DISPLAY_ENCODE
#include "effect/display.glsl"
#endif
#ifdef EFFECT_REFINE
#include "effect/edge.glsl"
#endif
#include "core/view.glsl"
#include "effect/sampling.glsl"
#ifdef EFFECT_WARP
#include "effect/warp.glsl"
#endif
#ifdef LAYERS
#include "stage/layer.glsl"
#endif
#include "shared/fragment_at.glsl"
#include "shared/frame.glsl"

#ifdef NEEDS_SAMPLING
#define SAMPLING_SHEARED 6.0   // N from which on the grid is sheared
#endif

#ifdef EFFECT_REFINE
#ifdef COMPUTES_PATCHES
vec2 patch_shift = vec2(0.0);   // stage/patch.glsl
#else
#ifdef BY_COMPUTE
const vec2 patch_shift = vec2(0.0);   // pixels with more rays are drawn by fragments
#else
flat in highp vec2 patch_shift;   // stage/tile_point.glsl
#endif
#endif

// Where a fragment's ray lies in the picture that is as fine as the rays of a pixel, from its lower left corner.
vec2 fragment_rays() { return fragment_at() + patch_shift; }
#endif

// The middle of a fragment's pixel, in that picture.
vec2 fragment_middle() {
#ifdef EFFECT_REFINE
    return (floor(fragment_rays() * sampling_px()) + 0.5) * sampling_rays();
#else
    return fragment_at() * sampling_rays();
#endif
}

// Of ray `number`: picture_place() of the picture that frame.image says, which is as fine as the rays of a pixel lie. N x N rays
// lie on a square grid, so that what they stand for fills the pixel. Where they are many each has a column and a row of its own, of N^2 by
// N^2: lines thinner than their distance are met evenly, along either axis too.
vec2 fragment_place(int number) {
#ifdef NEEDS_SAMPLING
#ifdef EFFECT_REFINE
    vec2 first = fragment_rays() - 0.5;   // a fragment is a ray: of its pixel's the first, and which it is
    vec2 cell = first - frame.sampling.z * floor((first + 0.5) * sampling_px());
    first -= cell;
#else
    int side = int(frame.sampling.z);
    vec2 cell = vec2(float(number % side), float(number / side));
    vec2 first = (fragment_at() - 0.5) * frame.sampling.z;
#endif
    vec2 within = frame.sampling.z < SAMPLING_SHEARED ? vec2(0.0) : (cell.yx + 0.5) * sampling_px() - 0.5;
    // In this order parts of a picture have the same rounding (render/picture_bands.h).
    return picture_place(first + 0.5) + (cell + within) * vec2(frame.sight.z, 1.0);
#else
    return picture_place(fragment_at());
#endif
}

// And where that ray looks: picture_place() of the projection's own picture.
vec2 fragment_pixel(int number) {
#ifdef EFFECT_WARP
    return warp_ray(fragment_place(number));
#else
    return fragment_place(number);
#endif
}

// Of a ray's light, and what else ray_light says, what is left behind a mesh. Called next after the ray's fragment_pixel().
vec4 fragment_light(vec4 light) {
#ifdef EFFECT_WARP
#ifdef LAYERS
    if (layer_shown >= LAYER_DISC_SHARES) warp_light = sign(warp_light);   // shares are no light
#endif
    return warp_light > 0.0 ? vec4(warp_light * light.rgb, light.a) : vec4(0.0);
#else
    return light;
#endif
}

// The half that a polariser takes of unpolarised light.
#ifdef EFFECT_POLARISER
#ifdef LAYERS
float light_passed() { return layer_shown < LAYER_STOKES ? 0.5 : 1.0; }   // shares are no light
#else
float light_passed() { return 0.5; }
#endif
#else
float light_passed() { return 1.0; }
#endif

// rgb: light; a: what of a point behind shines through, or the way that edges ask for.
vec4 fragment_colour(vec4 light) {
#ifdef BLOCK_PROJECTION
    // The part of the pixel that is in the picture: a fisheye's circle has a smooth edge.
    vec2 middle = picture_place(fragment_middle());
    float ray_px = sampling_px();
#ifdef EFFECT_WARP
    WarpPlace seen = warp_place(middle);
    middle = seen.light < 0.0 ? vec2(0.0) : seen.at;
    ray_px /= seen.share;
#endif
    light *= clamp(0.5 - beyond_view(middle) * ray_px, 0.0, 1.0);
#endif
    light.rgb *= light_passed();
    vec4 colour = vec4(light.rgb, 1.0);
#ifdef DISPLAY_ENCODE
    colour.rgb = display_encode(light.rgb, frame.image.w);
#endif
#ifdef EFFECT_POINT_STARS
    colour.a = light.a;
#else
#ifdef EFFECT_REFINE
    colour.a = edge_value(light.rgb, light.a);
#endif
#endif
    return colour;
}
