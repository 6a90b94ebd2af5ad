// A baseline of cost: one cube-map fetch a pixel and nothing else.
#include "shared/frame.glsl"

uniform samplerCube sky_texture;
out vec4 colour;

void main() {
    vec2 pixel = gl_FragCoord.xy - 0.5 * frame.image.xy;
    vec4 ray = frame.ray_0 + pixel.x * frame.ray_x + pixel.y * frame.ray_y;
    colour = vec4(textureLod(sky_texture, ray.xyz, 0.0).rgb, 1.0);
}
