#include "render/body_images.h"

#include <fmt/format.h>

#include "base/large_image.h"

namespace nullscope {

const char* body_image_sampler(int body) {
    constexpr const char* kSamplers[kBodyCount] = {"sphere_texture", "cylinder_texture", "ball_texture",
                                                   "surface_texture"};
    return kSamplers[body];
}

std::optional<std::filesystem::path> body_image_file(const Scene& scene, int body) {
    const BodyLook* looks[kBodyCount] = {
        scene.sphere ? &scene.sphere->look : nullptr, scene.cylinder ? &scene.cylinder->look : nullptr,
        scene.ball ? &scene.ball->look : nullptr, scene.surface ? &scene.surface->look : nullptr};
    if (looks[body] == nullptr || looks[body]->texture != TextureKind::kImage) return std::nullopt;
    return looks[body]->image;
}

std::string textures_end_at(int largest) { return fmt::format("textures end at {} px here", largest); }

Status BodyImages::update(const Scene& scene, int largest, std::vector<std::string>& notes) {
    for (int body = 0; body < kBodyCount; ++body) {
        std::optional<Picture>& picture = pictures_[static_cast<std::size_t>(body)];
        const auto file = body_image_file(scene, body);
        if (file && picture && picture->file == *file) continue;
        picture.reset();
        if (!file) continue;
        const auto fitted = load_fitted_image(*file, {.max_side = largest});
        if (!fitted) return fitted.error();
        if (fitted->reduced()) notes.push_back(reduction_words(*file, *fitted, textures_end_at(largest)));
        const Image<float>& image = fitted->image;
        picture = Picture{*file, image.width, image.height,
                          gl::make_picture_texture(image.width, image.height, image.channels, image.data.data())};
    }
    return Done{};
}

void BodyImages::bind(int first_unit) const {
    for (int body = 0; body < kBodyCount; ++body)
        if (const auto& picture = pictures_[static_cast<std::size_t>(body)])
            gl::bind_texture_2d(first_unit + body, picture->texture);
}

}  // namespace nullscope
