// How the screen stands to what is conserved of polarised light (observer/screen_form.h): G.(a + i b) where a pixel looks.
#include "core/pixel_view.glsl"
#include "shared/frame.glsl"

vec2 screen_phase(PixelView view) {
    vec3 n = vec3(view.at.x * frame.image.z, view.at.y * frame.image.z, view.at.z) * view.inverse_length;
    vec3 real = vec3(frame.screen_real.x, frame.screen_real.y, frame.screen_real.z);
    vec3 imaginary = vec3(frame.screen_imaginary.x, frame.screen_imaginary.y, frame.screen_imaginary.z);
    vec2 along = (vec2(real.z, imaginary.z) + vec2(dot(real, n), dot(imaginary, n))) / max(1.0 + n.z, 1.0e-6);
    return vec2(real.x - imaginary.y, imaginary.x + real.y) - vec2(n.x * along.x - n.y * along.y, n.x * along.y + n.y * along.x);
}
