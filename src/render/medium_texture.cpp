#include "render/medium_texture.h"

#include <fmt/format.h>

#include "plan/dump_window.h"
#include "scene/medium_dumps.h"

namespace nullscope {
namespace {

Status check_size(const gl::Info& info, int width, int height, int layers) {
    if (width <= info.max_texture_size && height <= info.max_texture_size && layers <= info.max_layers) return Done{};
    return bad_input(fmt::format("the grid of medium.file needs a texture of {}x{}, {} layers", width, height, layers),
                     fmt::format("at most {} a side and {} layers here", info.max_texture_size, info.max_layers));
}

}  // namespace

Status MediumTexture::update(const Scene& scene, const Spacetime& matter, const gl::Info& info) {
    if (!scene.medium || scene.medium->kind != MediumKind::kGrid) {
        *this = {};
        return Done{};
    }
    if (has_slow_light(scene)) return update_slow(scene, matter, info);
    TRY(grid, medium_grid_at(scene));
    if (form_ && of_.lock() == *grid) return Done{};
    const int width = 2 * (*grid)->rings().count, height = (*grid)->polar().count, layers = (*grid)->around().count;
    if (Status fits = check_size(info, width, height, layers); !fits) return fits;
    *this = {};  // before its successor is there too
    texture_ = gl::make_number_layers(width, height, layers, (*grid)->numbers().data());
    of_ = *grid;
    form_ = (*grid)->without_numbers();
    return Done{};
}

Status MediumTexture::update_slow(const Scene& scene, const Spacetime& matter, const gl::Info& info) {
    TRY(form, medium_form(scene));
    const GridMatter& series = scene.medium->grid;
    const DumpWindow window = dump_window(matter, scene, *form);
    const int width = 2 * form->rings().count, height = form->polar().count, layers = form->around().count;
    if (series_ != series || dumps_.size() != static_cast<std::size_t>(window.slots) ||
        form_->other_nodes(*form) != nullptr) {
        *this = {};
        if (Status fits = check_size(info, width, window.slots * height, layers); !fits) return fits;
        texture_ = gl::make_number_layers(width, window.slots * height, layers, nullptr);
        series_ = series, form_ = *form;
        dumps_.resize(static_cast<std::size_t>(window.slots));
    }
    for (int dump = window.first; dump <= window.last; ++dump) {
        const int slot = dump % window.slots;
        const DumpStamp stamp = dump_stamp(series, dump);
        auto& there = dumps_[static_cast<std::size_t>(slot)];
        if (there == stamp) continue;
        there.reset();
        TRY(grid, read_medium_dump(series, dump, *form));
        gl::set_number_rows(texture_, slot * height, width, height, layers, grid->numbers().data());
        there = stamp;
    }
    return Done{};
}

}  // namespace nullscope
