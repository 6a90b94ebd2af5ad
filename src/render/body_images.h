// Picture files as textures of the GPU: each once, kept until it changes.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/scene.h"
#include "shaderlib/body_text.h"

namespace nullscope {

std::string body_image_sampler(int image);  // of number `image` of body_images(): its sampler in the shader

struct PictureTexture {
    std::filesystem::path file;  // empty: no picture
    int width = 0, height = 0;
    gl::Texture texture;
    // largest: px along a side, beyond which the file is read smaller; notes: a line is added if it was. Errors: it cannot be read.
    Status update(const std::filesystem::path& wanted, int largest, std::vector<std::string>& notes);
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
