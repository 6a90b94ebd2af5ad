// Picture files as textures of the GPU: each once, kept until it changes.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "image/large_image.h"
#include "scene/scene.h"
#include "shaderlib/body_text.h"

namespace nullscope {

std::string body_image_sampler(int image);  // of number `image` of body_images(): its sampler in the shader

// An image on a solid body, which is opaque: without alpha. max_side: px.
inline ImageLimits body_image_limits(int max_side, const std::string& layer) {
    return {.max_side = max_side, .alpha = Alpha::kLeftOut, .layer = layer};
}

struct PictureTexture {
    ImageSource source;  // empty file: no picture
    int width = 0, height = 0;
    gl::Texture texture;
    // limits: max_side, beyond which the file is read smaller, what becomes of alpha, and the picture's layer; notes: lines are added, of what was done to it and
    // what of it is not used. Errors: it cannot be read.
    Status update(const std::filesystem::path& wanted, const ImageLimits& limits, std::vector<std::string>& notes);
};

// The images on solid bodies.
class BodyImages {
public:
    Status update(const Scene& scene, int largest, std::vector<std::string>& notes);
    void bind(int first_unit) const;  // units first_unit + number of the image
    const std::array<PictureTexture, kMostBodyImages>& pictures() const { return pictures_; }

private:
    std::array<PictureTexture, kMostBodyImages> pictures_;
};

}  // namespace nullscope
