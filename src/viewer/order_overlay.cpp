#include "viewer/order_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "studio/view_state.h"
#include "viewer/texture_id.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

using Rgb = std::array<unsigned char, 3>;
constexpr std::array<Rgb, kMostOrder + 1> kColours = {Rgb{40, 110, 255}, {255, 190, 30}, {240, 50, 90}, {190, 80, 255}};
constexpr unsigned char kOpacity = 120;  // of 255: the picture stays visible

}  // namespace

std::string no_orders(const Scene& scene) {
    if (scene.split) return "Not in a split screen: ray data are of a single spacetime.";
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr || spacetime->planar_rays()) return {};
    return "Not about a rotating hole: rays do not stay in a plane there, and swept angles are not computed.";
}

void OrderOverlay::take_rays(const Scene& scene, const RayFrame& rays) {
    if (!frame_.takes(scene)) return;
    std::vector<unsigned char> rgba;
    rgba.reserve(4 * rays.pixels.size());
    for (const RayPixel& pixel : rays.pixels) {
        const Rgb& colour = kColours[static_cast<std::size_t>(std::clamp(pixel.order, 0, kMostOrder))];
        const bool seen = pixel.fate != Fate::kCaptured && pixel.fate != Fate::kNoSky;
        rgba.insert(rgba.end(), colour.begin(), colour.end());
        rgba.push_back(seen ? kOpacity : 0);
    }
    tint_ = gl::make_rgba8_texture(rays.width, rays.height, rgba.data());
}

bool OrderOverlay::at_work() const { return asks_for_rays() || std::isfinite(wait()); }

void OrderOverlay::draw() const {
    if (frame_.has_rays())
        ImGui::GetBackgroundDrawList()->AddImage(id_of(tint_), {0.0f, 0.0f}, ImGui::GetIO().DisplaySize);
}

void draw_order_legend(float left, float right, float bottom) {
    const float margin = 0.6f * em(), swatch = 0.75f * em(), gap = 0.4f * em();
    const float padding = ImGui::GetStyle().WindowPadding.x, end = right - margin - padding;
    const char* title = "Image order";
    if (left + margin + padding + ImGui::CalcTextSize(title).x > end) return;
    overlay("##orders", left + margin, bottom - margin, 0.0f, 1.0f, 0.92f, [&] {
        ImGui::TextUnformatted(title);
        for (int order = 0; order <= kMostOrder; ++order) {
            const std::string words = fmt::format("{}{}", order, order < kMostOrder ? "" : " or more");
            ImGui::SameLine();
            if (ImGui::GetCursorScreenPos().x + swatch + gap + ImGui::CalcTextSize(words.c_str()).x > end)
                ImGui::NewLine();
            const Rgb& c = kColours[static_cast<std::size_t>(order)];
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float y = at.y + 0.5f * (ImGui::GetTextLineHeight() - swatch);
            ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + swatch, y + swatch},
                                                      IM_COL32(c[0], c[1], c[2], 255), 0.15f * em());
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + swatch + gap);
            ImGui::TextUnformatted(words.c_str());
        }
    });
}

}  // namespace nullscope::viewer
