// A star's light in one pixel: the display's point spread, a Gaussian.
#include "core/view.glsl"
#include "shared/frame.glsl"

flat in vec3 star_peak;
flat in vec2 star_middle;
#ifdef EFFECT_CUBE_FACES
flat in int star_face;
#endif
out vec4 colour;

void main() {
#ifdef EFFECT_CUBE_FACES
    if (face_of(picture_place(gl_FragCoord.xy)) != star_face) discard;
#endif
    vec2 off = (picture_place(gl_FragCoord.xy) - star_middle) / vec2(frame.sight.z, 1.0);
    colour = vec4(star_peak * exp2(-dot(off, off) * frame.point_spread.x), 1.0);
}
