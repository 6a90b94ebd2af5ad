#include "render/medium_texture.h"

#include <fmt/format.h>

#include "scene/medium_dumps.h"

namespace nullscope {

Status MediumTexture::update(const Scene& scene, const gl::Info& info) {
    if (!scene.medium || scene.medium->kind != MediumKind::kGrid) {
        *this = {};
        return Done{};
    }
    TRY(grid, medium_grid_at(scene));
    if (form_ && of_.lock() == *grid) return Done{};
    const int width = 2 * (*grid)->rings().count, height = (*grid)->polar().count, layers = (*grid)->around().count;
    if (width > info.max_texture_size || height > info.max_texture_size || layers > info.max_layers)
        return bad_input(
            fmt::format("the grid of medium.file needs a texture of {}x{}, {} layers", width, height, layers),
            fmt::format("at most {} a side and {} layers here", info.max_texture_size, info.max_layers));
    *this = {};  // before its successor is there too
    texture_ = gl::make_number_layers(width, height, layers, (*grid)->numbers().data());
    of_ = *grid;
    form_ = (*grid)->without_numbers();
    return Done{};
}

}  // namespace nullscope
