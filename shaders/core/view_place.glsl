// Where in the picture a direction is seen: the inverse of core/view.glsl.
#include "core/view.glsl"
#include "core/seen_place.glsl"
#include "shared/frame.glsl"

// view: unit; to the right, upward, ahead.
ViewPlace view_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    float ahead = max(view.z, 1.0e-6);
    ViewPlace place = ViewPlace(view.xy / (ahead * unit), view.z > 0.0, square * view.z * view.z * view.z);
#ifdef BLOCK_PROJECTION
#include "generated/projection_place"   // returns its place
#endif
    return place;
}
