// Pixels that have more rays than one, drawn as patches of a target of its own: a fragment for each ray, side by side, so that all that a driver
// shades at once is of use (llvmpipe: 4 x 4 fragments; pixels on a line are two or three of these). Their means are the picture's pixels.
#pragma once
#include <functional>
#include <vector>

#include "gl/gl.h"

namespace nullscope {

// Pixels along a side of a patch, of side x side rays a pixel.
constexpr int patch_pixels(int side) { return side < 4 ? 2 : 1; }

// From one to the next in the target, rays, and the target's rows that hold so many, as shaders/stage/patch_place.glsl has them.
constexpr int patch_step(int side) { return (patch_pixels(side) * side + 3) / 4 * 4; }
int patch_rows(int side, int count);

class RayPatches {
public:
    void resize(gl::Format format);  // of the picture's light; texels: kPatchesSide squared
    void clear() { rays_ = {}; }

    using Draw = std::function<void(const gl::VertexList& pixels, const gl::Target& rays)>;
    // side x side rays of the patches' pixels (column and row of the lowest left one, in turn; multiples of patch_pixels()): `draw` draws them by the picture's programs and then,
    // `to_picture`, their means, as often as all need it.
    void draw(int side, const std::vector<float>& pixels, const Draw& draw, const Draw& to_picture) const;

private:
    gl::Target rays_;
    gl::Format format_ = gl::Format::kRgba16F;
};

}  // namespace nullscope
