#include "render/ray_patches.h"

#include <algorithm>

#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

int patches_across(int side) { return kPatchesSide / patch_step(side); }

}  // namespace

int patch_rows(int side, int count) {
    return (count + patches_across(side) - 1) / patches_across(side) * patch_step(side);
}

void RayPatches::resize(gl::Format format) {
    if (rays_.width > 0 && format == format_) return;
    rays_ = gl::make_target(kPatchesSide, kPatchesSide, format);
    format_ = format;
}

void RayPatches::draw(int side, const std::vector<float>& pixels, const Draw& draw, const Draw& to_picture) const {
    const std::ptrdiff_t most = std::ptrdiff_t{2} * patches_across(side) * patches_across(side);
    for (auto first = pixels.begin(); first != pixels.end();) {
        const auto last = first + std::min(most, pixels.end() - first);
        const gl::VertexList list = gl::make_vertex_list({first, last}, {2});
        draw(list, rays_);
        to_picture(list, rays_);
        first = last;
    }
}

}  // namespace nullscope
