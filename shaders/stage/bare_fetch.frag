// A baseline of cost: one cube-map fetch a pixel and nothing else.
#include "core/view.glsl"
#include "shared/frame.glsl"

uniform samplerCube sky_texture;
out vec4 colour;

void main() {
    vec2 pixel = picture_place(gl_FragCoord.xy);
    vec4 ray = view_form(frame.ray_0, frame.ray_x, frame.ray_y, pixel_view(pixel));
    colour = vec4(textureLod(sky_texture, ray.xyz, 0.0).rgb, 1.0);
}
