#include "render/body_images.h"

#include <fmt/format.h>

#include <utility>

#include "image/half_float.h"
#include "image/half_levels.h"

namespace nullscope {

std::string body_image_sampler(int image) { return fmt::format("body_image_{}", image); }

Status PictureTexture::update(const std::filesystem::path& wanted, const ImageLimits& limits,
                              std::vector<std::string>& notes) {
    const ImageSource asked{wanted, limits.layer};
    if (source == asked) return Done{};
    *this = {};
    if (wanted.empty()) return Done{};
    TRY(fitted, load_fitted_image(wanted, limits));
    notes.insert(notes.end(), fitted->notes.begin(), fitted->notes.end());
    if (fitted->reduced())
        notes.push_back(
            reduction_words(wanted, *fitted, fmt::format("textures are limited to {} px here", limits.max_side)));
    if (const std::size_t beyond = count_beyond_half(fitted->image.data); beyond > 0)
        notes.push_back(fmt::format("'{}': {} numbers above {:g}, the largest half float, are drawn as that",
                                    wanted.string(), beyond, kMostHalf));
    source = asked, width = fitted->image.width, height = fitted->image.height;
    const std::vector<HalfLevel> levels = half_levels(std::move(fitted->image));
    std::vector<gl::HalfTexels> texels;
    texels.reserve(levels.size());
    for (const HalfLevel& level : levels) texels.push_back({level.width, level.height, level.rgba.data()});
    texture = gl::make_picture_texture(texels);
    return Done{};
}

Status BodyImages::update(const Scene& scene, int largest, std::vector<std::string>& notes) {
    const auto files = body_images(scene);
    if (files.size() > pictures_.size())
        return bad_input(fmt::format("{} different images on bodies", files.size()),
                         fmt::format("at most {}", pictures_.size()));
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        const ImageSource source = i < files.size() ? files[i] : ImageSource();
        TRY(made, pictures_[i].update(source.file, body_image_limits(largest, source.layer), notes));
    }
    return Done{};
}

void BodyImages::bind(int first_unit) const {
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        if (pictures_[i].texture) gl::bind_texture_2d(first_unit + static_cast<int>(i), pictures_[i].texture);
}

}  // namespace nullscope
