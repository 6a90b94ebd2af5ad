#include "viewer/picture_marks.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "annotate/ticks.h"
#include "viewer/texture_id.h"

namespace nullscope::viewer {
namespace {

Annotations annotations_at(Scene scene, PixelSize size) {
    scene.camera.width = size.width, scene.camera.height = size.height;
    return annotations_of(scene, halves(scene));
}

}  // namespace

void PictureMarks::show(const Scene& scene, PixelSize size, int top, int bottom) {
    Annotations now = annotations_at(scene, size);
    if (now == annotations_ && size == size_ && top == top_ && bottom == bottom_) return;
    annotations_ = std::move(now), size_ = size, top_ = top, bottom_ = bottom;
    marks_ = make_marks(annotations_, size.width, size.height, top, bottom).marks;
    textures_.clear();
    for (const Mark& mark : marks_)
        textures_.push_back(gl::make_rgba8_texture(mark.rgba.width, mark.rgba.height, mark.rgba.data.data()));
}

void PictureMarks::draw() const {
    const float unit = ImGui::GetIO().DisplaySize.x / static_cast<float>(size_.width);  // of a framebuffer's pixel
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const Mark& mark = marks_[i];
        const auto at = [&](int x, int y) {
            return ImVec2(unit * static_cast<float>(x), unit * static_cast<float>(y));
        };
        ImGui::GetBackgroundDrawList()->AddImage(id_of(textures_[i]), at(mark.x, mark.y),
                                                 at(mark.x + mark.rgba.width, mark.y + mark.rgba.height));
    }
}

float PictureMarks::labels_bottom() const {
    const int most = size_.height / 4;  // the line between the halves is taller
    int bottom = 0;
    for (const Mark& mark : marks_)
        if (mark.y < most && mark.rgba.height < most) bottom = std::max(bottom, mark.y + mark.rgba.height);
    return ImGui::GetIO().DisplaySize.x / static_cast<float>(size_.width) * static_cast<float>(bottom);
}

void mark_saved_picture(const Scene& scene, const Image<float>& stokes, Image<unsigned char>& picture) {
    const PixelSize size{picture.width, picture.height};
    if (!stokes.empty()) lay_over(tick_marks(stokes, size.width, size.height), picture);
    lay_over(make_marks(annotations_at(scene, size), size.width, size.height).marks, picture);
}

}  // namespace nullscope::viewer
