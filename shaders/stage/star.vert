// One image of one star: where in the picture it is, and the light that its pixels share.
#include "core/view.glsl"
#ifdef EFFECT_WARP
#include "effect/warp.glsl"
#endif
#include "path/stars"
#include "shared/frame.glsl"

layout(location = 0) in vec3 star_place;   // what star_point takes
layout(location = 1) in vec2 star_make;
flat out vec3 star_peak;
flat out vec2 star_middle;                 // picture_place()
#ifdef EFFECT_CUBE_FACES
flat out int star_face;                    // that it is drawn on
#endif

void main() {
    StarPoint point = star_point(star_place, star_make);
    star_peak = point.peak;
#ifdef EFFECT_CUBE_FACES
    // On every face: the rim of its light too.
    PixelView looks = cube_view(point.pixel);
    star_face = gl_InstanceID;
    vec3 turned = on_face(vec3(looks.at.xy * frame.image.z, looks.at.z), star_face);
    point.seen = point.seen && turned.z > 0.0;
    vec2 on_plane = turned.xy / max(turned.z, 1.0e-6);
    point.seen = point.seen && max(abs(on_plane.x), abs(on_plane.y)) < 1.0 + frame.point_stars.w * frame.image.z;
    point.pixel = on_plane / frame.image.z + face_middle(star_face);
#else
#ifdef BLOCK_PROJECTION
    // Round the camera: again at the picture's other side.
    if (gl_InstanceID == 1) point.pixel.x -= point.pixel.x < 0.0 ? -frame.projection.z : frame.projection.z;
#endif
#endif
#ifdef EFFECT_WARP
    WarpPlace on_screen = warp_seen(point.pixel);
    point.pixel = on_screen.at;
    point.seen = point.seen && on_screen.light > 0.0;
    star_peak *= warp_factor(on_screen.light) * on_screen.share * on_screen.share;
#endif
    star_middle = point.pixel;
    vec2 fragment = picture_fragment(point.pixel);
    float bright = max(max(star_peak.r, star_peak.g), star_peak.b) * frame.image.w;
    float reach2 = log2(bright * frame.point_stars.z) * frame.point_stars.y;
    bool seen_here = point.seen && reach2 > 0.0;
    gl_PointSize = 2.0 * ceil(sqrt(max(reach2, 0.0))) + 1.0;
    gl_Position = seen_here ? vec4((fragment - 0.5 * frame.image.xy) / (0.5 * frame.image.xy + frame.point_stars.w), 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
