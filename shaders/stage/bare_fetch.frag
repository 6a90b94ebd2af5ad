// A baseline of cost: one fetch of the sky a pixel and nothing else.
#include "core/view.glsl"
#include "object/sky_face.glsl"
#include "shared/frame.glsl"

uniform highp sampler2DArray sky_texture;
out vec4 colour;

void main() {
    vec2 pixel = picture_place(gl_FragCoord.xy);
    vec4 ray = view_form(frame.ray_0, frame.ray_x, frame.ray_y, pixel_view(pixel));
    colour = vec4(textureLod(sky_texture, sky_face_place(sky_face(ray.xyz), ray.xyz), 0.0).rgb, 1.0);
}
