// What a projection says of a pixel (projection/NAME.glsl). Places in the picture are px of a pixel's height from the line of sight, x to the
// right, y up.
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

// A pixel's longer side over PixelView.angle, at most.
float pixel_longest() { return max(frame.sight.z, inversesqrt(frame.sight.z)); }

// form: of pixels to the right and upward, and ahead (frame.ray_x, ray_y, ray_0); the unit direction's.
vec4 view_form(vec4 ahead, vec4 right, vec4 up, PixelView view) {
    return (view.at.z * ahead + view.at.x * right + view.at.y * up) * view.inverse_length;
}

#ifdef BLOCK_PROJECTION
#define NARROW_SHARE 0.1        // of a pixel's angle in the middle, at least: next to the poles and the antipode pixels are narrow strips
#define SMALL_ANGLE 0.01        // below it sin(t)/t is 1 - t^2/6

float view_share(float share) { return max(sqrt(max(share, 0.0)), NARROW_SHARE); }
#endif
