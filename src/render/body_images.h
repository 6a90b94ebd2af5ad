// The image textures of solid bodies on the GPU: one for each body that has one, kept until its file changes.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr int kBodyCount = 4;       // sphere, cylinder, ball, surface
const char* body_image_sampler(int body);  // its sampler in the shader

class BodyImages {
public:
    // largest: px along a side, beyond which images are read smaller; notes: a line is added for each that was. Errors: an image
    // that cannot be read.
    Status update(const Scene& scene, int largest, std::vector<std::string>& notes);
    void bind(int first_unit) const;  // units first_unit + body

    struct Picture {
        std::filesystem::path file;
        int width = 0, height = 0;
        gl::Texture texture;
    };
    const std::array<std::optional<Picture>, kBodyCount>& pictures() const { return pictures_; }

private:
    std::array<std::optional<Picture>, kBodyCount> pictures_;
};

// Why an image was made smaller.
std::string textures_end_at(int largest);

// The file of a body's image texture, if it has one.
std::optional<std::filesystem::path> body_image_file(const Scene& scene, int body);

}  // namespace nullscope
