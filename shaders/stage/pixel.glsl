// Where a fragment's rays go, and what becomes of their light.
#ifdef DISPLAY_ENCODE
#include "effect/display.glsl"
#endif
#ifdef EFFECT_REFINE
#include "effect/edge.glsl"
#endif
#include "core/view.glsl"
#include "effect/sampling.glsl"
#include "shared/frame.glsl"

#ifdef NEEDS_SAMPLING
#define SAMPLING_SHEARED 6.0   // N from which on the grid is sheared
#endif

// Of ray `number`: picture_place() of the picture that frame.image says, which is as fine as the rays of a pixel lie. N x N rays
// lie on a square grid, so that what they stand for fills the pixel. Where they are many each has a column and a row of its own, of N^2 by
// N^2: lines thinner than their distance are met evenly, along either axis too.
vec2 fragment_pixel(int number) {
#ifdef NEEDS_SAMPLING
    int side = int(frame.sampling.z);
    vec2 cell = vec2(float(number % side), float(number / side));
    vec2 within = frame.sampling.z < SAMPLING_SHEARED ? vec2(0.0) : (cell.yx + 0.5) * sampling_share() - 0.5;
    // In this order parts of a picture have the same rounding (render/picture_bands.h).
    return picture_place((gl_FragCoord.xy - 0.5) * frame.sampling.z + 0.5) + (cell + within) * vec2(frame.sight.z, 1.0);
#else
    return picture_place(gl_FragCoord.xy);
#endif
}

// rgb: light; a: what of a point behind shines through, or the way that edges ask for.
vec4 fragment_colour(vec4 light) {
#ifdef BLOCK_PROJECTION
    // The part of the pixel that is in the picture: a fisheye's circle has a smooth edge.
    light *= clamp(0.5 - beyond_view(picture_place(gl_FragCoord.xy * sampling_rays())) * sampling_share(), 0.0, 1.0);
#endif
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
