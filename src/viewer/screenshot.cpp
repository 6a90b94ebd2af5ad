#include "viewer/screenshot.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "gl/gl.h"

namespace nullscope::viewer {

Image<unsigned char> drawn_apart(PixelSize size, const std::function<void(unsigned framebuffer)>& draw) {
    const gl::Target target = gl::make_target(size.width, size.height, gl::Format::kRgba8);
    draw(target.framebuffer.id());
    std::vector<unsigned char> rgba(static_cast<std::size_t>(size.width) * size.height * 4);
    gl::read_rgba8(target, rgba.data());
    Image<unsigned char> image(size.width, size.height, 3);
    for (int y = 0; y < size.height; ++y) {
        const unsigned char* from = rgba.data() + static_cast<std::size_t>(size.height - 1 - y) * size.width * 4;
        for (int x = 0; x < size.width; ++x) std::copy_n(from + 4 * x, 3, image.at(x, y));
    }
    return image;
}

std::filesystem::path fresh_screenshot_path() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    const std::string stem = fmt::format("nullscope-{:%Y%m%d-%H%M%S}", local);
    std::filesystem::path path = std::filesystem::absolute(stem + ".png");
    for (int n = 2; std::filesystem::exists(path); ++n) path.replace_filename(fmt::format("{}-{}.png", stem, n));
    return path;
}

}  // namespace nullscope::viewer
