#include "viewer/card_pictures.h"

#include <algorithm>

#include "image/image_file.h"
#include "viewer/texture_id.h"

namespace nullscope::viewer {
namespace {

constexpr long long kMostPixels = 4'000'000;

gl::Texture texture_of(const Image<float>& image) {
    gl::Texture texture = gl::make_rgba8_texture(image.width, image.height, rgba8_of(image).data());
    gl::set_linear(texture);
    return texture;
}

}  // namespace

const CardPicture* CardPictures::find(const std::filesystem::path& file, bool all) {
    auto found = pictures_.find(file);
    if (found == pictures_.end()) {
        if (read_in_this_frame_ && !all) {
            loading_ = true;
            return nullptr;
        }
        read_in_this_frame_ = true;
        found = pictures_.emplace(file, CardPicture()).first;
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) return nullptr;
        if (const auto image = load_image(file, kMostPixels)) {
            found->second.texture = texture_of(*image);
            found->second.shape = static_cast<float>(image->height) / static_cast<float>(image->width);
        }
    }
    return found->second.texture ? &found->second : nullptr;
}

void draw_card_picture(const CardPicture* picture, ImVec2 at, float width, bool over) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float height = CardPicture::kShape * width;
    const ImVec2 corner{at.x + width, at.y + height};
    draw.AddRectFilled(at, corner, IM_COL32(0, 0, 0, 255));
    if (picture != nullptr) {  // a wider one has bars, of a taller one the middle is shown
        const float bar = 0.5f * std::max(0.0f, height - picture->shape * width);
        const float cut = 0.5f * std::max(0.0f, 1.0f - height / (picture->shape * width));
        draw.AddImage(id_of(picture->texture), {at.x, at.y + bar}, {corner.x, corner.y - bar}, {0.0f, cut},
                      {1.0f, 1.0f - cut});
    }
    if (over)
        draw.AddRect({at.x - 1.0f, at.y - 1.0f}, {corner.x + 1.0f, corner.y + 1.0f},
                     ImGui::GetColorU32(ImGuiCol_CheckMark), 0.0f, 0, 2.0f);
}

}  // namespace nullscope::viewer
