// What the viewer does with bookmarks.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "image/area_filter.h"
#include "image/image_file.h"
#include "scenefile/scene_writer.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

constexpr int kPictureWidth = 320;  // px

// Display-encoded, top row first; the mean is one of light. rgba: bottom row first.
Image<unsigned char> reduced(PixelSize from, const std::vector<unsigned char>& rgba, PixelSize to) {
    AreaFilter filter(from.width, from.height, 3, to.width, to.height);
    std::vector<float> row(3 * static_cast<std::size_t>(from.width));
    for (int y = from.height - 1; y >= 0; --y) {
        const unsigned char* pixels = rgba.data() + 4 * static_cast<std::size_t>(y) * from.width;
        std::size_t i = 0;
        for (int x = 0; x < from.width; ++x, pixels += 4)
            for (int c = 0; c < 3; ++c) row[i++] = linear_from_srgb(static_cast<float>(pixels[c]) / 255.0f);
        filter.add_row(row.data());
    }
    const Image<float> small = filter.take();
    const std::vector<unsigned char> encoded = rgba8_of(small);
    Image<unsigned char> image(small.width, small.height, 3);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            std::copy_n(encoded.data() + 4 * (static_cast<std::size_t>(y) * small.width + x), 3, image.at(x, y));
    return image;
}

}  // namespace

// Of the picture on the screen. The driver halves it while it is much too large, so that few pixels are read back: 10 ms.
Image<unsigned char> Viewer::small_picture() const {
    if (!shown_.is_there()) return {};
    PixelSize size{shown_.painting.width, shown_.painting.height};
    gl::Target target;
    for (unsigned texture = shown_.painting.texture;; texture = target.colours[0].id()) {
        const bool halve = size.width > 2 * kPictureWidth && size.height > 1;
        const PixelSize next = halve ? PixelSize{size.width / 2, size.height / 2} : size;
        gl::Target smaller = gl::make_target(next.width, next.height, gl::Format::kRgba8);
        gl::blit(texture, size.width, size.height, smaller.framebuffer.id(), next.width, next.height);
        target = std::move(smaller);
        size = next;
        if (!halve) break;
    }
    std::vector<unsigned char> rgba(4 * static_cast<std::size_t>(size.width) * size.height);
    gl::read_rgba8(target, rgba.data());
    const int width = std::min(size.width, kPictureWidth);
    return reduced(size, rgba, {width, std::max(1, size.height * width / size.width)});
}

// With the picture of this view, if it is not too long in coming.
void Viewer::keep_bookmark() {
    if (!due_.bookmark || !(settled() || in_motion() || controls_.dragging())) return;
    due_.bookmark = false;
    Scene scene = view_.scene;
    set_size(scene, view_.loaded.camera.width, view_.loaded.camera.height);
    const auto kept = panels_.bookmarks.add(scene, view_.source, small_picture());
    say(kept ? fmt::format("Bookmarked as {} (B shows the bookmarks)", *kept) : kept.error().message());
    pace_.want(kSettlingFrames);
}

// No recent file: it is found among the bookmarks.
bool Viewer::open_bookmark(const std::string& file) {
    const std::vector<std::string> own = view_.own;
    const bool opened = open_file(file);
    view_.own = own;
    return opened;
}

// What is shown stays, where an observer can be as the bookmark's camera is.
bool Viewer::take_camera(const std::string& file) {
    const auto kept = load_scene(file);
    if (!kept) return say(kept.error().message()), false;
    history_.rest(view_);
    const Status taken = paste_view(view_, view_line(kept->camera));
    say(taken ? fmt::format("The camera of {}", kept->name)
              : fmt::format("Cannot use the camera of {}: {}", kept->name, taken.error().message()));
    return static_cast<bool>(taken);
}

bool Viewer::follow_bookmarks() {
    BookmarkPanel& strip = panels_.bookmark_strip;
    due_.bookmark |= std::exchange(strip.add_pressed, false);
    if (!strip.message.empty()) say(std::exchange(strip.message, {}));
    const auto chosen = std::exchange(panels_.bookmark, {});
    if (chosen.file.empty()) return false;
    return chosen.camera_only ? take_camera(chosen.file) : open_bookmark(chosen.file);
}

}  // namespace nullscope::viewer
