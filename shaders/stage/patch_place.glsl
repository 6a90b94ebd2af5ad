// Where patches of rays lie in their target (render/ray_patches.h): pixels that are drawn again with more rays, a fragment or thread for each ray.
#include "effect/sampling.glsl"
#include "generated/tiles"

bool draws_patches() { return sampling_rays() > 1.0; }

// Pixels along its side.
float patch_pixels() { return sampling_rays() < 4.0 ? 2.0 : 1.0; }

// From one to the next, rays: software drivers shade blocks of 4 x 4 fragments.
int patch_step() { return (int(patch_pixels() * sampling_rays()) + 3) / 4 * 4; }
int patches_across() { return PATCHES_SIDE / patch_step(); }

// Its lower left corner in the target.
vec2 patch_corner(int number) {
    int across = patches_across();
    return float(patch_step()) * vec2(float(number % across), float(number / across));
}

// From there to its rays' place in the picture that is as fine as the rays lie. pixel: column, and row from below, of its lowest left pixel.
vec2 patch_shift_of(int number, vec2 pixel) { return sampling_rays() * pixel - patch_corner(number); }
