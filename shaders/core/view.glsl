// Where a pixel looks: the camera's projection (scene/projection.h; the inverse: core/view_place.glsl). Places in the picture are px of a pixel's height from
// the line of sight, x to the right, y up.
#ifdef BLOCK_PROJECTION
#include "core/trig.glsl"
#endif
#include "shared/frame.glsl"

// Of a place in the framebuffer, px from its lower left corner; and back.
vec2 picture_place(vec2 fragment) { return vec2((fragment.x - frame.sight.x) * frame.sight.z, fragment.y - frame.sight.y); }
vec2 picture_fragment(vec2 place) { return vec2(place.x / frame.sight.z + frame.sight.x, place.y + frame.sight.y); }

struct PixelView {
    vec3 at;                // the view direction in pixels to the right and upward, and ahead:
    float inverse_length;   //   times this it is a unit vector
    float angle;            // that the pixel spans, rad: the square root of its solid angle; of a pinhole as if pixels were square
};

// form: of pixels to the right and upward, and ahead (frame.ray_x, ray_y, ray_0); the unit direction's.
vec4 view_form(vec4 ahead, vec4 right, vec4 up, PixelView view) {
    return (view.at.z * ahead + view.at.x * right + view.at.y * up) * view.inverse_length;
}

#ifdef BLOCK_PROJECTION
#define NARROW_SHARE 0.1        // of a pixel's angle in the middle, at least: next to the poles and the antipode pixels are narrow strips
#define SMALL_ANGLE 0.01        // below it sin(t)/t is 1 - t^2/6

float view_share(float share) { return max(sqrt(max(share, 0.0)), NARROW_SHARE); }

// How far beyond what the picture shows, px of its height; negative within.
float beyond_view(vec2 place) {
    float way = frame.projection.x == 1.0 ? sqrt(dot(place, place)) : abs(place.y);
    return way - frame.projection.y;
}
#endif
#ifdef EFFECT_FISHEYE
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
#endif
#ifdef EFFECT_EQUIRECTANGULAR
PixelView equirectangular_view(vec2 place) {
    vec2 longitude = sine_cosine(place.x * frame.image.z);
    vec2 latitude = sine_cosine(place.y * frame.image.z);
    PixelView view;
    view.at = vec3(latitude.y * longitude.x / frame.image.z, latitude.x / frame.image.z, latitude.y * longitude.y);
    view.inverse_length = 1.0;
    view.angle = frame.sight.w * view_share(latitude.y);
    return view;
}
#endif
#ifdef EFFECT_CYLINDRICAL
PixelView cylindrical_view(vec2 place) {
    vec2 longitude = sine_cosine(place.x * frame.image.z);
    float slope = place.y * frame.image.z;
    PixelView view;
    view.at = vec3(longitude.x / frame.image.z, place.y, longitude.y);
    view.inverse_length = inversesqrt(1.0 + slope * slope);
    view.angle = frame.sight.w * view.inverse_length * sqrt(view.inverse_length);
    return view;
}
#endif

#ifdef EFFECT_CUBE_FACES
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
PixelView faces_view(vec2 place) {
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
#endif

#ifdef EFFECT_WARP
float pixel_share = 1.0;   // of a pixel's angle: what a mesh leaves of it at the place that is looked at (effect/warp.glsl)
#endif

// As if the picture had no mesh.
PixelView projection_view(vec2 place) {
#ifdef EFFECT_CUBE_FACES
    if (frame.projection.x == 4.0) return faces_view(place);
#endif
#ifdef EFFECT_FISHEYE
    if (frame.projection.x == 1.0) return fisheye_view(place);
#endif
#ifdef EFFECT_EQUIRECTANGULAR
    if (frame.projection.x == 2.0) return equirectangular_view(place);
#endif
#ifdef EFFECT_CYLINDRICAL
    if (frame.projection.x == 3.0) return cylindrical_view(place);
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
