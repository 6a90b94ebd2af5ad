// The histogram of the picture on the screen, with what exposure is judged by. Of a comparison: side A.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "studio/levels.h"
#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kHistogramWidth = 19.0f, kPlotHeight = 7.0f;  // of the font's size
constexpr int kMostCounted = 1 << 21;                         // pixels; 25 ms with llvmpipe
constexpr ImU32 kPlotGround = IM_COL32(14, 15, 19, 255);      // under colours that add, in either theme
constexpr const char* kPlotHelp =
    "Pixels (of a large picture a part of them) by their red, green and blue values as displayed, from black to full; "
    "height: the square root of their "
    "number. The bar on the right: one of the three is at its end.";

struct Counted {
    int number = -1;  // of the picture
    PictureLevels levels;
};

// Of large pictures the middle pixel of each 3 x 3, 5 x 5 ...: there a filtered copy has the pixel itself.
PictureLevels levels_of(const Painting& painting) {
    int step = 1;
    while (painting.width / step * (painting.height / step) > kMostCounted) step += 2;
    const int width = std::max(painting.width / step, 1), height = std::max(painting.height / step, 1);
    const gl::Target target = gl::make_target(width, height, gl::Format::kRgba8);
    gl::blit(painting.texture, step * width, step * height, target.framebuffer.id(), width, height);
    std::vector<unsigned char> rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl::read_rgba8(target, rgba.data());
    return picture_levels(rgba);
}

// Light of these colours: bits of red, green, blue.
ImU32 mixed(unsigned colours) {
    const auto part = [&](unsigned bit) { return (colours & bit) != 0 ? 200 : 60; };
    return IM_COL32(part(1), part(2), part(4), 255);
}

void draw_curves(const PictureLevels& levels) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = kPlotHeight * em(), base = from.y + height;
    draw.AddRectFilled(from, {from.x + width, base}, kPlotGround);
    const double most = static_cast<double>(levels.most());
    const float column = width / static_cast<float>(levels.luma.size());
    for (std::size_t value = 0; value < levels.luma.size(); ++value) {
        std::array<std::pair<float, unsigned>, 3> tops;  // and bits of colours
        for (unsigned colour = 0; colour < 3; ++colour) {
            const double share = std::min(static_cast<double>(levels.colours[colour][value]) / most, 1.0);
            tops[colour] = {base - height * static_cast<float>(std::sqrt(share)), 1u << colour};
        }
        std::ranges::sort(tops, std::greater());
        const float left = from.x + static_cast<float>(value) * column;
        float below = base;
        unsigned colours = 7;  // that reach so high
        for (const auto& [top, colour] : tops) {
            if (top < below) draw.AddRectFilled({left, top}, {left + column, below}, mixed(colours));
            below = top, colours &= ~colour;
        }
    }
    for (const float part : {0.25f, 0.5f, 0.75f})
        draw.AddLine({from.x + part * width, from.y}, {from.x + part * width, base}, packed(dark_palette().border));
    if (levels.clipped > 0)
        draw.AddRectFilled({from.x + width - 0.2f * em(), from.y}, {from.x + width, base}, packed(palette().refusal));
    ImGui::Dummy({width, height});
    tooltip(kPlotHelp);
}

void draw_levels(const PictureLevels& levels, const NumberStyle& style) {
    const auto line = [&](const char* name, double share, int decimals, const char* help) {
        constexpr double kLeast = 1e-4;  // that has digits
        const bool little = share > 0.0 && share < kLeast;
        text_row(name, help);
        const std::string number = fixed_words(100.0 * (little ? kLeast : share), style, decimals);
        ImGui::TextUnformatted(((little ? "below " : "") + number + " %").c_str());
    };
    const auto luma = [&](double share) { return levels.luma_of(share) / 255.0; };
    const auto part = [&](std::size_t count) {
        return static_cast<double>(count) / static_cast<double>(levels.pixels);
    };
    line("Median", luma(0.5), 1, "Half of the pixels are no brighter: luma (Rec. 709) as displayed, 100 % is white.");
    line("99 % below", luma(0.99), 1, "All but the brightest hundredth of the pixels are no brighter.");
    line("Brightest", luma(1.0), 1, "Luma of the brightest pixel.");
    line("Clipped", part(levels.clipped), 2, "Pixels in which red, green or blue is at its end: their colour is lost.");
    line("Black", part(levels.black), 2, "Pixels without any light.");
}

void draw_histogram(PanelPlace& place) {
    const Painting& painting = place.facts.painting;
    auto* counted = std::any_cast<Counted>(place.kept);
    if (counted == nullptr) counted = &place.kept->emplace<Counted>();
    if (painting.texture != 0 && counted->number != place.facts.number)
        *counted = {place.facts.number, levels_of(painting)};
    const float margin = kPanelMargin * em(), width = kHistogramWidth * em();
    const bool fits = width + 2.0f * margin <= place.right - place.left;
    const float right = fits ? place.right : ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos({right - margin, place.top + margin}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSize({width, 0.0f});
    if (ImGui::Begin("Histogram", &place.open,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        if (counted->levels.pixels > 0) {
            draw_curves(counted->levels);
            draw_levels(counted->levels, place.view.numbers);
        } else
            paragraph("No picture yet.");
        place.changed |= slide_key("camera.exposure", "Exposure", place.view.scene.camera.exposure_ev, -10.0, 10.0,
                                   "%+.2f EV", "The picture's brightness is multiplied by 2^EV.");
    }
    ImGui::End();
}

}  // namespace

const Panel kHistogramPanel{
    .menu = "View",
    .name = "Histogram",
    .keys = "G",
    .key = GLFW_KEY_G,
    .words = "how bright the pixels are",
    .help = "How many pixels are how bright, and how many are black or clipped; with the exposure.",
    .hides_picture = true,
    .draw = draw_histogram,
};

}  // namespace nullscope::viewer
