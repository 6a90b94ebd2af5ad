#include "render/picture_tiles.h"

#include <algorithm>

namespace nullscope {
namespace {

void resize_target(gl::Target& target, bool wanted, int width, int height, int count) {
    if (!wanted)
        target = {};
    else if (target.width != width || target.height != height || static_cast<int>(target.colours.size()) != count)
        target = gl::make_target(width, height, gl::Format::kRgba32F, count);
}

}  // namespace

void PictureTiles::resize(const std::vector<Pass>& passes, int width, int height, const EffectSet& effects) {
    const int side = tile_side(effects), across = tiles_along(width, side), up = tiles_along(height, side);
    const bool rays = passes.front().stage == Stage::kRays;
    const bool tiles = std::ranges::any_of(passes, [](const Pass& pass) { return finds_tiles(pass.stage); });
    resize_target(rays_, rays, rays_a_tile(effects) * (across + 3), up + 3,
                  interpolates_disc(effects)     ? 3
                  : tiles_classify_disc(effects) ? 2
                                                 : 1);
    resize_target(tiles_, tiles, across, up, 1);
    // Of odd sizes: llvmpipe compiles once more for textures whose sides are powers of two.
    const bool large = tiles && has_tiles(effects);
    const auto odd = [](int count) { return std::max((count + kFirstTiles - 1) / kFirstTiles, 3) | 1; };
    resize_target(large_, large, odd(across), odd(up), 1);
    resize_target(none_, large, 3, 3, 1);
}

void PictureTiles::find(Stage stage, const gl::Program& program, const std::function<void(const gl::Target&)>& draw) {
    if (stage == Stage::kRays) return draw(rays_);
    if (large_.width > 0) {
        gl::bind_texture_2d(first_, none_.colours.front());
        gl::set_integer(program, "tile_scale", kFirstTiles);
        draw(large_);
        gl::bind_texture_2d(first_, large_.colours.front());
        gl::set_integer(program, "tile_scale", 1);
    }
    draw(tiles_);
    gl::bind_texture_2d(first_, tiles_.colours.front());
}

void PictureTiles::bind(int first) {
    first_ = first;
    if (tiles_.width > 0) gl::bind_texture_2d(first, tiles_.colours.front());
    for (std::size_t i = 0; i < rays_.colours.size(); ++i)
        gl::bind_texture_2d(first + 1 + static_cast<int>(i), rays_.colours[i]);
}

}  // namespace nullscope
