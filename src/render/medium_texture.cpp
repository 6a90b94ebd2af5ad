#include "render/medium_texture.h"

#include <fmt/format.h>

namespace nullscope {

Status MediumTexture::update(const std::optional<MediumSpec>& medium, const gl::Info& info) {
    if (!medium || medium->kind != MediumKind::kGrid) {
        *this = {};
        return Done{};
    }
    TRY(grid, load_medium_grid(medium->grid.file));
    if (grid_ == *grid) return Done{};
    const int width = 2 * (*grid)->rings().count, height = (*grid)->polar().count, layers = (*grid)->around().count;
    if (width > info.max_texture_size || height > info.max_texture_size || layers > info.max_layers)
        return bad_input(
            fmt::format("the grid of medium.file needs a texture of {}x{}, {} layers", width, height, layers),
            fmt::format("at most {} a side and {} layers here", info.max_texture_size, info.max_layers));
    *this = {};  // before its successor is there too
    texture_ = gl::make_number_layers(width, height, layers, (*grid)->numbers().data());
    grid_ = *grid;
    return Done{};
}

}  // namespace nullscope
