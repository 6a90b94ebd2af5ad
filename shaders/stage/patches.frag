// A pixel's light: the mean of its rays.
#include "effect/sampling.glsl"

uniform highp sampler2D picture_texture;   // of the patches
flat in highp vec2 patch_shift;
out vec4 colour;

void main() {
    int side = int(sampling_rays());
    ivec2 low = side * ivec2(gl_FragCoord.xy) + ivec2(patch_shift);
    vec4 sum = vec4(0.0);
    for (int number = 0; number < side * side; ++number) sum += texelFetch(picture_texture, low + ivec2(number % side, number / side), 0);
    colour = sum / float(side * side);
}
