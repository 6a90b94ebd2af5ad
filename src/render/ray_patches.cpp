#include "render/ray_patches.h"

#include <algorithm>

#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// Patches in the target, as stage/tile_point.glsl places them.
int most_patches(int side) {
    const int rays = patch_pixels(side) * side, step = (rays + 3) / 4 * 4, across = kPatchesSide / step;
    return across * across;
}

}  // namespace

void RayPatches::resize(gl::Format format) {
    if (rays_.width > 0 && format == format_) return;
    rays_ = gl::make_target(kPatchesSide, kPatchesSide, format);
    format_ = format;
}

void RayPatches::draw(int side, const std::vector<float>& pixels, const Draw& draw, const Draw& to_picture) const {
    const std::ptrdiff_t most = 2 * most_patches(side);
    for (auto first = pixels.begin(); first != pixels.end();) {
        const auto last = first + std::min(most, pixels.end() - first);
        const gl::VertexList list = gl::make_vertex_list({first, last}, {2});
        draw(list, rays_);
        to_picture(list, rays_);
        first = last;
    }
}

}  // namespace nullscope
