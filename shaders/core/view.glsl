// Where a pixel looks: the camera's projection (scene/projection_row.h; the inverse: core/view_place.glsl).
#include "core/pixel_view.glsl"
#ifdef BLOCK_PROJECTION
#include "generated/projection"   // its functions; beyond_view()
#endif
#include "shared/frame.glsl"

#ifdef EFFECT_WARP
float pixel_share = 1.0;   // of a pixel's angle: what a mesh leaves of it at the place that is looked at (effect/warp.glsl)
#endif

// As if the picture had no mesh.
PixelView projection_view(vec2 place) {
#ifdef BLOCK_PROJECTION
#include "generated/projection_view"   // returns its view
#endif
    PixelView view;
    view.at = vec3(place, 1.0);
    view.inverse_length = inversesqrt(1.0 + dot(place, place) * (frame.image.z * frame.image.z));
    view.angle = frame.image.z * view.inverse_length * sqrt(view.inverse_length);
    return view;
}

PixelView pixel_view(vec2 place) {
    PixelView view = projection_view(place);
#ifdef EFFECT_WARP
    view.angle *= pixel_share;
#endif
    return view;
}
