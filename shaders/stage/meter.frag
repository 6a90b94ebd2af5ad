// The picture's mean luminance, from its coarsest level.
#include "effect/luminance.glsl"

uniform highp sampler2D source_texture;
out vec4 colour;

void main() {
    ivec2 size = textureSize(source_texture, 0);
    float sum = 0.0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) sum += luminance_of(texelFetch(source_texture, ivec2(x, y), 0).rgb);
    // In browsers light beyond 65504 is infinite, which would stay in an adapting mean for ever.
    colour = vec4(vec3(min(sum / float(size.x * size.y), 1.0e30)), 1.0);
}
