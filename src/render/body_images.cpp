#include "render/body_images.h"

#include <fmt/format.h>

#include "image/large_image.h"

namespace nullscope {

std::string body_image_sampler(int image) { return fmt::format("body_image_{}", image); }

Status PictureTexture::update(const std::filesystem::path& wanted, int largest, std::vector<std::string>& notes) {
    if (file == wanted) return Done{};
    *this = {};
    if (wanted.empty()) return Done{};
    TRY(fitted, load_fitted_image(wanted, {.max_side = largest}));
    if (fitted->reduced())
        notes.push_back(reduction_words(wanted, *fitted, fmt::format("textures are limited to {} px here", largest)));
    const Image<float>& image = fitted->image;
    texture = gl::make_picture_texture(image.width, image.height, image.channels, image.data.data());
    file = wanted, width = image.width, height = image.height;
    return Done{};
}

Status BodyImages::update(const Scene& scene, int largest, std::vector<std::string>& notes) {
    const auto files = body_images(scene);
    if (files.size() > pictures_.size())
        return bad_input(fmt::format("{} different images on bodies", files.size()),
                         fmt::format("at most {}", pictures_.size()));
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        TRY(made, pictures_[i].update(i < files.size() ? files[i] : std::filesystem::path(), largest, notes));
    }
    return Done{};
}

void BodyImages::bind(int first_unit) const {
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        if (pictures_[i].texture) gl::bind_texture_2d(first_unit + static_cast<int>(i), pictures_[i].texture);
}

}  // namespace nullscope
