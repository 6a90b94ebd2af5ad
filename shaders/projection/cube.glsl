// Six faces of a cube.
#include "core/pixel_view.glsl"
#ifdef NEEDS_VIEW_PLACE
#include "core/seen_place.glsl"
#endif
#include "shared/frame.glsl"

// The faces of a picture of three columns and two rows: left, ahead, right above down, behind, up.
int face_of(vec2 place) {
    float side = 2.0 / frame.image.z;
    int column = int(clamp(floor(place.x / side + 1.5), 0.0, 2.0));
    return place.y >= 0.0 ? column : 3 + column;
}
vec2 face_middle(int face) {
    float side = 2.0 / frame.image.z;
    return vec2(float(face % 3 - 1) * side, face < 3 ? 0.5 * side : -0.5 * side);
}
PixelView cube_view(vec2 place) {
    int face = face_of(place);
    vec2 at = place - face_middle(face);
    float far = 1.0 / frame.image.z;
    PixelView view;
    view.at = vec3(at, 1.0);
    if (face == 0) view.at = vec3(-far, at.y, at.x * frame.image.z);
    if (face == 2) view.at = vec3(far, at.y, -at.x * frame.image.z);
    if (face == 3) view.at = vec3(at.x, -far, at.y * frame.image.z);
    if (face == 4) view.at = vec3(-at.x, at.y, -1.0);
    if (face == 5) view.at = vec3(at.x, far, -at.y * frame.image.z);
    view.inverse_length = inversesqrt(1.0 + dot(at, at) * (frame.image.z * frame.image.z));
    view.angle = frame.sight.w * view.inverse_length * sqrt(view.inverse_length);
    return view;
}
// In a face's own axes: to its right, upward and ahead. view: to the camera's right, upward, ahead.
vec3 on_face(vec3 view, int face) {
    vec3 turned = view;
    if (face == 0) turned = vec3(view.z, view.y, -view.x);
    if (face == 2) turned = vec3(-view.z, view.y, view.x);
    if (face == 3) turned = vec3(view.x, view.z, -view.y);
    if (face == 4) turned = vec3(-view.x, view.y, -view.z);
    if (face == 5) turned = vec3(view.x, -view.z, view.y);
    return turned;
}

#ifdef NEEDS_VIEW_PLACE
ViewPlace cube_place(vec3 view) {
    float unit = frame.image.z;
    float square = frame.sight.w * frame.sight.w;
    int face = 0;
    for (int other = 1; other < 6; ++other)
        if (on_face(view, other).z > on_face(view, face).z) face = other;
    vec3 turned = on_face(view, face);
    return ViewPlace(turned.xy / (turned.z * unit) + face_middle(face), true, square * turned.z * turned.z * turned.z);
}
#endif
