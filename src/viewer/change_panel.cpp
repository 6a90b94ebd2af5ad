// What changes in the picture as a number of its scene grows: arrows from where each thing is to where it goes. Computed on the processor, in the double
// precision of gradient/: some hundred rays a picture, which a shader of its own would have to be compiled for.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "annotate/ticks.h"
#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kChangeWidth = 17.0f, kLoopWidth = 18.0f;  // of the font's size
constexpr double kLongestArrow = 0.9;                      // of what they are apart, of the 95th percentile
constexpr double kUsual = 0.95, kNarrow = 0.5;
constexpr double kLeastMotion_px =
    1e-6;  // below are roundings: 1e-12 of a camera that comes nearer to a sky in flat space
constexpr double kColouredDown = 0.02;  // of the 95th percentile: all below has the first colour
constexpr const char* kChangeHelp =
    "Where each place of the sky or of the disc moves to in the picture. Blue moves least, yellow most; nothing is "
    "drawn next to the critical curve, nor in the "
    "shadow.";

struct ChangeChoice {
    std::string key;
};

// The share-th of their lengths, px.
double length_at(const std::vector<ChangeArrow>& arrows, double share) {
    std::vector<double> lengths;
    lengths.reserve(arrows.size());
    for (const ChangeArrow& arrow : arrows) lengths.push_back(std::hypot(arrow.right, arrow.down));
    if (lengths.empty()) return 0.0;
    const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lengths.size() - 1));
    std::ranges::nth_element(lengths, at);
    return *at;
}

// The largest of 1, 2, 5, 10 ... by which arrows of this length are at most so long.
double enlargement(double length, double most) {
    if (!(length > 0.0)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(most / length))), rest = most / (length * power);
    return power * (rest >= 5.0 ? 5.0 : rest >= 2.0 ? 2.0 : 1.0);
}

// From blue over white to yellow, by the logarithm of the length: told apart by all kinds of colour vision.
ImU32 colour_of(double length, double longest) {
    const double low = std::log(kColouredDown),
                 part = std::clamp(1.0 - std::log(std::max(length / longest, kColouredDown)) / low, 0.0, 1.0);
    const auto mixed = [&](double first, double middle, double last) {
        return static_cast<int>(part < 0.5 ? std::lerp(first, middle, 2.0 * part)
                                           : std::lerp(middle, last, 2.0 * part - 1.0));
    };
    return IM_COL32(mixed(70, 225, 255), mixed(130, 230, 195), mixed(255, 235, 40), 255);
}

void draw_arrow(ImDrawList& draw, ImVec2 from, ImVec2 to, float thick, ImU32 colour) {
    constexpr float kOutline = 2.2f;  // of a line's thickness
    constexpr float kHead = 0.35f, kLargestHead = 5.0f, kHalfOpening = 0.55f;
    const ImU32 dark = IM_COL32(0, 0, 0, 150);
    const float right = to.x - from.x, down = to.y - from.y, length = std::hypot(right, down);
    const float head = std::min(kHead * length, kLargestHead * thick);
    const auto wing = [&](float side) {
        const float angle = std::atan2(down, right) + static_cast<float>(M_PI) + side * kHalfOpening;
        return ImVec2{to.x + head * std::cos(angle), to.y + head * std::sin(angle)};
    };
    for (const bool outline : {true, false}) {
        const ImU32 ink = outline ? dark : colour;
        const float wide = outline ? kOutline * thick : thick;
        draw.AddLine(from, to, ink, wide);
        if (length > 2.0f * thick) draw.AddLine(wing(-1.0f), to, ink, wide), draw.AddLine(wing(1.0f), to, ink, wide);
    }
}

// times: as long as they are drawn, of what they are. longest: px, of those drawn: longer ones are cut to it.
void draw_arrows(const std::vector<ChangeArrow>& arrows, const CameraSpec& camera, double times, double longest) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const double unit = static_cast<double>(screen.x) / camera.width;
    const auto thick = static_cast<float>(unit * tick_thickness(camera.width, camera.height));
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const ChangeArrow& arrow : arrows) {
        const double length = std::hypot(arrow.right, arrow.down);
        const double shown = times * std::min(1.0, longest / std::max(length, 1e-300));
        const ImVec2 from{static_cast<float>(unit * arrow.x), static_cast<float>(unit * arrow.y)};
        draw_arrow(draw, from,
                   {static_cast<float>(unit * (arrow.x + shown * arrow.right)),
                    static_cast<float>(unit * (arrow.y + shown * arrow.down))},
                   thick, colour_of(length, longest));
    }
}

// The chosen one, or the first; draws the list.
const ChangeKey& choose_key(const std::vector<ChangeKey>& keys, ChangeChoice& chosen, bool shut) {
    const auto found = std::ranges::find(keys, chosen.key, &ChangeKey::name);
    const ChangeKey* key = found == keys.end() ? &keys.front() : &*found;
    row("By", kChangeHelp);
    choice("##by", fmt::format("{} {}", key->name, key->words), shut, [&] {
        for (const ChangeKey& each : keys)
            if (choice_item(fmt::format("{} {}", each.name, each.words), each.name == key->name, ""))
                chosen.key = each.name, key = &each;
    });
    return *key;
}

// As many rows while they are found, so that nothing moves under the pointer.
void draw_change_numbers(const ChangeWatch& watch, double times, double usual) {
    const auto line = [&](const char* name, const std::string& words, const char* help) {
        text_row(name, help);
        ImGui::TextUnformatted(watch.at_work() ? "..." : words.c_str());
    };
    const bool any = usual >= kLeastMotion_px;
    line("Median", fmt::format("{:.2g} px", any ? length_at(watch.arrows(), kNarrow) : 0.0),
         "Half of the arrows are shorter.");
    line("95 % below", fmt::format("{:.2g} px", any ? usual : 0.0), "Longer ones are drawn as long as this.");
    line("Drawn",
         !any           ? "nothing moves"
         : times == 1.0 ? "as long as they are"
                        : fmt::format("{:g} times as long", times),
         "A round number, so that arrows do not cross each other.");
}

void draw_changes(PanelPlace& place) {
    ChangeWatch& watch = place.parts.changes;
    auto* chosen = std::any_cast<ChangeChoice>(place.kept);
    if (chosen == nullptr) chosen = &place.kept->emplace<ChangeChoice>();
    const Painting& painting = place.facts.painting;
    const CameraSpec& camera = painting.job.scene.camera;
    const std::vector<ChangeKey> keys = change_keys(place.view.scene);
    const double usual = length_at(watch.arrows(), kUsual);
    const double apart = static_cast<double>(std::max(camera.width, 1)) /
                         tick_grid(std::max(camera.width, 1), std::max(camera.height, 1)).columns;
    const double times = enlargement(usual, kLongestArrow * apart);
    const float margin = kPanelMargin * em();
    const bool low = is_open(place.view, kHistogramPanel);  // what else is open has the lower corner
    float right = place.right;
    for (const auto& [panel, width] :
         {std::pair{&kTelescopePanel, kTelescopeWidth}, std::pair{&kLoopPanel, kLoopWidth}})
        if (const float beside = width * em() + margin;
            low && is_open(place.view, *panel) && place.left + beside + kChangeWidth * em() + margin < right)
            right -= beside;
    ImGui::SetNextWindowPos({right - margin, place.bottom - margin}, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowSize({kChangeWidth * em(), 0.0f});
    if (ImGui::Begin("What changes", &place.open,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        const ChangeKey& key = choose_key(keys, *chosen, place.escape);
        if (painting.texture != 0)
            watch.look(place.facts.number, painting.job.scene, key, !painting.coarse(), [] { glfwPostEmptyEvent(); });
        watch.error().empty() ? draw_change_numbers(watch, times, usual) : paragraph(watch.error(), true);
    }
    ImGui::End();
    if (usual >= kLeastMotion_px) draw_arrows(watch.arrows(), camera, times, usual);
}

std::string no_changes(const ViewState& view) {
    if (view.scene.split) return "Not in a split screen.";
    return view.side_b != nullptr ? "Not in a comparison (X)." : "";
}

}  // namespace

const Panel kChangePanel{
    .menu = "View",
    .name = "What changes",
    .keys = "J",
    .key = GLFW_KEY_J,
    .words = "where all moves as spin, place or view grow",
    .help = "Arrows over the picture: where what is seen moves to as a number of the scene grows by a little.",
    .hides_picture = true,
    .why_not = no_changes,
    .draw = draw_changes,
    .forget = [](PanelParts& parts) { parts.changes.forget(); },
};

}  // namespace nullscope::viewer
