#include "render/body_images.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/image_file.h"

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

Status BodyImages::update(const Scene& scene, int largest) {
    for (int body = 0; body < kBodyCount; ++body) {
        std::optional<Picture>& picture = pictures_[static_cast<std::size_t>(body)];
        const auto file = body_image_file(scene, body);
        if (file && picture && picture->file == *file) continue;
        picture.reset();
        if (!file) continue;
        const auto image = load_image(*file);
        if (!image) return image.error();
        if (std::max(image->width, image->height) > largest)
            return bad_input(fmt::format("{}: {}x{} px; this driver's textures end at {} px", file->string(),
                                         image->width, image->height, largest));
        picture = Picture{*file, image->width, image->height,
                          gl::make_picture_texture(image->width, image->height, image->channels, image->data.data())};
    }
    return Done{};
}

void BodyImages::bind(int first_unit) const {
    for (int body = 0; body < kBodyCount; ++body)
        if (const auto& picture = pictures_[static_cast<std::size_t>(body)])
            gl::bind_texture_2d(first_unit + body, picture->texture);
}

}  // namespace nullscope
