// A fisheye: azimuthal equidistant.
#include "core/pixel_view.glsl"
#include "core/trig.glsl"
#ifdef NEEDS_VIEW_PLACE
#include "core/seen_place.glsl"
#endif
#include "shared/frame.glsl"

PixelView fisheye_view(vec2 place) {
    float angle = sqrt(dot(place, place)) * frame.image.z;
    vec2 turn = sine_cosine(angle);
    float scale = angle < SMALL_ANGLE ? 1.0 - angle * angle * (1.0 / 6.0) : turn.x / angle;
    PixelView view;
    view.at = vec3(place * scale, turn.y);
    view.inverse_length = 1.0;
    view.angle = frame.sight.w * view_share(scale);
    return view;
}

#ifdef NEEDS_VIEW_PLACE
ViewPlace fisheye_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    float aside = length(view.xy);
    float angle = arc_tangent2(aside, view.z);
    float stretch = aside > 1.0e-6 ? angle / aside : 1.0;
    return ViewPlace(view.xy * (stretch / unit), true, square / stretch);
}
#endif
