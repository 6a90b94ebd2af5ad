#include "render/sky_textures.h"

#include <algorithm>
#include <utility>

#include "base/assets.h"
#include "sky/packed_sky.h"

namespace nullscope {

void SkyTextures::begin(const std::optional<SkySpec>& near, const std::optional<SkySpec>& far, int size) {
    if (near_ == near && far_ == far && size_ == size) return;
    *this = {};
    near_ = near, far_ = far, size_ = size;
    const int border = size / kBorderOf;
    for (const auto* spec : {&near_, &far_})
        if (*spec)
            painters_.push_back(std::async(std::launch::async, [spec = **spec, size, border] {
                return SkyPainter::make(spec, assets_directory(), size, border);
            }));
}

Status SkyTextures::finish(std::vector<std::string>& notes) {
    if (painters_.empty()) return Done{};
    SkyTextures work = std::exchange(*this, {});  // nothing stays loaded where something fails
    std::vector<SkyPainter> painters;
    double largest = 0.0;
    for (auto& coming : std::exchange(work.painters_, {})) {
        TRY(painter, coming.get());
        for (std::string& note : painter->notes()) notes.push_back(std::move(note));
        if (painter->is_image()) work.packing_.format = SkyFormat::kHalfFloats;
        // A made sky is held within what small floats hold.
        largest = std::max(largest, painter->is_image() ? painter->largest() : kMostHalf);
        painters.push_back(std::move(*painter));
    }
    work.packing_.scale = packing_scale(work.packing_.format, largest);
    const bool halves = work.packing_.format == SkyFormat::kHalfFloats;
    work.layers_ =
        gl::make_sky(bordered_size(work.size_), sky_levels(work.size_), 6 * static_cast<int>(painters.size()), halves);
    int layer = 0;
    for (const SkyPainter& painter : painters) {
        pack_sky(painter, work.packing_, [&](const PackedRows& rows) {
            gl::fill_sky(work.layers_,
                         {layer + rows.face, rows.level, rows.first, rows.count, rows.width, halves, rows.texels});
        });
        layer += 6;
    }
    gl::check("sky");
    *this = std::move(work);
    return Done{};
}

void SkyTextures::bind(int near_unit, int far_unit) const {
    gl::bind_texture_layers(near() ? near_unit : far_unit, layers_);
}

}  // namespace nullscope
