// The pixels of a patch of rays (render/ray_patches.h), as a point of the picture.
#include "shared/frame.glsl"
#include "stage/tile_point.glsl"

void main() {
    patch_shift = patch_corner(gl_VertexID) - sampling_rays() * patch_pixel;   // from a pixel to its rays
    gl_PointSize = patch_pixels();
    gl_Position = vec4((2.0 * patch_pixel + gl_PointSize) * sampling_rays() / frame.image.xy - 1.0, 0.0, 1.0);
}
