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

Result<bool> SkyTextures::finish(std::vector<std::string>& notes, const std::function<bool()>& goes_on) {
    if (painters_.empty() && left_.empty()) return true;
    SkyTextures work = std::exchange(*this, {});  // nothing stays loaded where something fails
    do {
        TRY(made, work.make_next(notes));
    } while (!work.left_.empty() && goes_on());
    gl::check("sky");
    *this = std::move(work);
    return left_.empty();
}

// The painters, the texture, then a piece of a sky.
Status SkyTextures::make_next(std::vector<std::string>& notes) {
    if (!painters_.empty()) return make_painters(notes);
    const bool halves = packing_.format == SkyFormat::kHalfFloats;
    if (layers_)
        upload_next(halves);
    else
        layers_ = gl::make_sky(bordered_size(size_), sky_levels(size_), 6 * static_cast<int>(left_.size()), halves);
    return Done{};
}

Status SkyTextures::make_painters(std::vector<std::string>& notes) {
    double largest = 0.0;
    for (auto& coming : std::exchange(painters_, {})) {
        TRY(painter, coming.get());
        for (std::string& note : painter->notes()) notes.push_back(std::move(note));
        if (painter->is_image()) packing_.format = SkyFormat::kHalfFloats;
        // A made sky is held within what small floats hold.
        largest = std::max(largest, painter->is_image() ? painter->largest() : kMostHalf);
        left_.insert(left_.begin(), std::move(*painter));
    }
    packing_.scale = packing_scale(packing_.format, largest);
    return Done{};
}

void SkyTextures::upload_next(bool halves) {
    if (!packer_) packer_ = std::make_unique<SkyPacker>(left_.back(), packing_);
    const int layer = near_ && far_ && left_.size() == 1 ? 6 : 0;
    const bool more = packer_->next([&](const PackedRows& rows) {
        gl::fill_sky(layers_, {layer + rows.face, rows.level, rows.first, rows.count, rows.width, halves, rows.texels});
    });
    if (more) return;
    packer_.reset();
    left_.pop_back();
}

void SkyTextures::bind(int near_unit, int far_unit) const {
    gl::bind_texture_layers(near() ? near_unit : far_unit, layers_);
}

}  // namespace nullscope
