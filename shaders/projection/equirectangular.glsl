// Longitude and latitude.
#include "core/pixel_view.glsl"
#include "core/trig.glsl"
#ifdef NEEDS_VIEW_PLACE
#include "core/seen_place.glsl"
#endif
#include "shared/frame.glsl"

PixelView equirectangular_view(vec2 place) {
    vec2 longitude = sine_cosine(place.x * frame.image.z);
    vec2 latitude = sine_cosine(place.y * frame.image.z);
    PixelView view;
    view.at = vec3(latitude.y * longitude.x / frame.image.z, latitude.x / frame.image.z, latitude.y * longitude.y);
    view.inverse_length = 1.0;
    view.angle = frame.sight.w * view_share(latitude.y);
    return view;
}

#ifdef NEEDS_VIEW_PLACE
ViewPlace equirectangular_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    float level = length(view.xz);
    return ViewPlace(vec2(bearing(view.x, view.z), bearing(view.y, level)) / unit, true, square * level);
}
#endif
