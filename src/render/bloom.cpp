#include "render/bloom.h"

#include <algorithm>

namespace nullscope {

std::vector<std::pair<int, int>> Bloom::levels(int width, int height) {
    constexpr int kCoarsest = 8;
    std::vector<std::pair<int, int>> sizes;
    do {
        width = std::max(1, (width + 1) / 2);
        height = std::max(1, (height + 1) / 2);
        sizes.emplace_back(width, height);
    } while (width > kCoarsest || height > kCoarsest);
    return sizes;
}

std::size_t Bloom::bytes(int width, int height) {
    std::size_t texels = 0, coarsest = 0;
    for (const auto& [w, h] : levels(width, height)) {
        coarsest = static_cast<std::size_t>(w) * h;
        texels += 2 * coarsest;
    }
    return gl::bytes_of(gl::filtered_light()) * (texels - coarsest);
}

void Bloom::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    down_.clear();
    up_.clear();
    width_ = width;
    height_ = height;
    for (const auto& [w, h] : levels(width, height))
        for (auto* targets : {&down_, &up_}) {
            targets->push_back(gl::make_target(w, h, gl::filtered_light()));
            gl::set_linear(targets->back().colours.front());
        }
    up_.pop_back();  // the coarsest level is its own sum
}

std::size_t Bloom::bytes() const {
    std::size_t texels = 0;
    for (const auto* targets : {&down_, &up_})
        for (const gl::Target& target : *targets) texels += static_cast<std::size_t>(target.width) * target.height;
    return gl::bytes_of(gl::filtered_light()) * texels;
}

void Bloom::draw_down(const gl::Program& down, const gl::VertexArray& empty, const gl::Texture& picture,
                      int source_unit) {
    const gl::Texture* source = &picture;
    for (const gl::Target& target : down_) {
        gl::bind_texture_2d(source_unit, *source);
        gl::draw_fullscreen(down, empty, target.framebuffer.id(), target.width, target.height);
        source = &target.colours.front();
    }
}

void Bloom::draw_up(const gl::Program& up, const gl::VertexArray& empty, int source_unit, int bloom_unit) {
    for (std::size_t level = up_.size(); level-- > 0;) {
        gl::bind_texture_2d(source_unit, down_[level].colours.front());
        gl::bind_texture_2d(bloom_unit, (level + 1 < up_.size() ? up_[level + 1] : down_[level + 1]).colours.front());
        gl::draw_fullscreen(up, empty, up_[level].framebuffer.id(), up_[level].width, up_[level].height);
    }
}

void Bloom::draw_meter(const gl::Program& meter, const gl::VertexArray& empty, int source_unit, double share) {
    if (!meter_) share = 1.0;
    if (!meter_) meter_ = gl::make_target(1, 1, gl::Format::kRgba32F);
    gl::bind_texture_2d(source_unit, down_.back().colours.front());
    gl::draw_fullscreen(meter, empty, meter_->framebuffer.id(), 1, 1, share);
}

}  // namespace nullscope
