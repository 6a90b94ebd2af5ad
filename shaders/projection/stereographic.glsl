// Stereographic: r = 2 tan(theta/2).
#include "core/pixel_view.glsl"
#ifdef NEEDS_VIEW_PLACE
#include "core/seen_place.glsl"
#endif
#include "shared/frame.glsl"

PixelView stereographic_view(vec2 place) {
    float tangent2 = 0.25 * dot(place, place) * (frame.image.z * frame.image.z);   // of half the angle from the line of sight, squared
    PixelView view;
    view.at = vec3(place, 1.0 - tangent2);
    view.inverse_length = 1.0 / (1.0 + tangent2);
    view.angle = frame.sight.w * view.inverse_length;
    return view;
}

#ifdef NEEDS_VIEW_PLACE
ViewPlace stereographic_place(vec3 view) {
    // Half of 1 + cos(theta), the scale there: behind the camera by the sine.
    float scale = 0.5 * (view.z >= 0.0 ? 1.0 + view.z : dot(view.xy, view.xy) / (1.0 - view.z));
    float pixel = frame.sight.w * scale;
    return ViewPlace(view.xy / (max(scale, 1.0e-12) * frame.image.z), scale > 1.0e-12, pixel * pixel);
}
#endif
