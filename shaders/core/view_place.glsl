// Where in the picture a direction is seen: the inverse of core/view.glsl.
#include "core/view.glsl"
#include "shared/frame.glsl"
#ifdef BLOCK_PROJECTION
#include "core/trig.glsl"
#endif

struct ViewPlace {
    vec2 at;         // px of a pixel's height from the line of sight, y up
    bool seen;       // not behind a pinhole
    float pixels;    // solid angle of a pixel there, sr
};

// view: unit; to the right, upward, ahead.
ViewPlace view_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    float ahead = max(view.z, 1.0e-6);
    ViewPlace place = ViewPlace(view.xy / (ahead * unit), view.z > 0.0, square * view.z * view.z * view.z);
#ifdef EFFECT_CUBE_FACES
    int face = 0;
    for (int other = 1; other < 6; ++other)
        if (on_face(view, other).z > on_face(view, face).z) face = other;
    vec3 turned = on_face(view, face);
    place = ViewPlace(turned.xy / (turned.z * unit) + face_middle(face), true, square * turned.z * turned.z * turned.z);
#endif
#ifdef EFFECT_FISHEYE
    float aside = length(view.xy);
    float angle = arc_tangent2(aside, view.z);
    float stretch = aside > 1.0e-6 ? angle / aside : 1.0;
    place = ViewPlace(view.xy * (stretch / unit), true, square / stretch);
#endif
#ifdef EFFECT_EQUIRECTANGULAR
    float level = length(view.xz);
    place = ViewPlace(vec2(bearing(view.x, view.z), bearing(view.y, level)) / unit, true, square * level);
#endif
#ifdef EFFECT_CYLINDRICAL
    float level = max(length(view.xz), 1.0e-6);
    place = ViewPlace(vec2(bearing(view.x, view.z), view.y / level) / unit, true, square * level * level * level);
#endif
    return place;
}
