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
    const int border = both() ? size / kBorderOf : 0;
    for (const auto* spec : {&near_, &far_})
        if (*spec)
            painters_.push_back(std::async(std::launch::async, [spec = **spec, size, border] {
                return SkyPainter::make(spec, assets_directory(), size, border);
            }));
}

Status SkyTextures::finish(std::vector<std::string>& notes) {
    if (painters_.empty()) return Done{};
    SkyTextures work = std::exchange(*this, {});  // nothing stays loaded where something fails
    const int levels = sky_levels(work.size_, work.both());
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
    gl::Texture& texture = work.both() ? work.layers_ : work.near_ ? work.near_cube_ : work.far_cube_;
    texture = gl::make_sky(work.both() ? bordered_size(work.size_) : work.size_, levels, work.both() ? 12 : 0, halves);
    int layer = 0;
    for (const SkyPainter& painter : painters) {
        pack_sky(painter, work.packing_, [&](const PackedRows& rows) {
            gl::fill_sky(texture, work.both(),
                         {layer + rows.face, rows.level, rows.first, rows.count, rows.width, halves, rows.texels});
        });
        layer += 6;
    }
    gl::check("sky");
    *this = std::move(work);
    return Done{};
}

void SkyTextures::bind(int near_unit, int far_unit) const {
    gl::bind_texture_cube(near_unit, near_cube_);
    gl::bind_texture_layers(near_unit, layers_);
    gl::bind_texture_cube(far_unit, far_cube_);
}

}  // namespace nullscope
