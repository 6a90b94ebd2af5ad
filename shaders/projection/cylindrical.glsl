// On a cylinder: longitude, and the tangent of the latitude.
#include "core/pixel_view.glsl"
#include "core/trig.glsl"
#ifdef NEEDS_VIEW_PLACE
#include "core/seen_place.glsl"
#endif
#include "shared/frame.glsl"

PixelView cylindrical_view(vec2 place) {
    vec2 longitude = sine_cosine(place.x * frame.image.z);
    float slope = place.y * frame.image.z;
    PixelView view;
    view.at = vec3(longitude.x / frame.image.z, place.y, longitude.y);
    view.inverse_length = inversesqrt(1.0 + slope * slope);
    view.angle = frame.sight.w * view.inverse_length * sqrt(view.inverse_length);
    return view;
}

#ifdef NEEDS_VIEW_PLACE
ViewPlace cylindrical_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    float level = max(length(view.xz), 1.0e-6);
    return ViewPlace(vec2(bearing(view.x, view.z), view.y / level) / unit, true, square * level * level * level);
}
#endif
