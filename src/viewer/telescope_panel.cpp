#include "viewer/telescope_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "render/display.h"
#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/small_light.h"
#include "viewer/telescope_plots.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kCurveHeight = 6.5f, kPlaneSide = 10.0f;  // of the font's size
constexpr double kUas = M_PI / 180 / 3600e6;              // rad
constexpr const char* kSeenNames[] = {"as it is", "through a beam", "as baselines resolve it"};
constexpr const char* kSeenHelp =
    "The picture as it is drawn; through a Gaussian beam; or as baselines up to the longest one resolve it, which is a "
    "round beam as wide as their finest fringe. The ellipse in the corner is the beam's full width at half of its "
    "maximum.";
constexpr const char* kLongestHelp =
    "In thousand million wavelengths: of the curve, of the (u, v) plane and, if chosen, of the picture. The Earth "
    "allows 9.8 at 1.3 mm.";

Result<std::vector<Station>> usual_array() {
    const auto file = assets_directory() / "telescopes" / "eht-2017.csv";
    auto text = read_text(file);
    if (!text) return text.error();
    return read_stations(*text, file.string());
}

std::string source_words(const LiveSource& source, const Image<float>& light, const NumberStyle& style) {
    const auto uas = [&](int pixels) { return number_words(pixels * source.pixel / kUas, style, 3); };
    std::string words = (source.assumed_object ? "As if of " : "") + source.object;
    words += fmt::format(
        ", {} x {} \xc2\xb5"
        "as, {} GHz",
        uas(light.width), uas(light.height), number_words(source.frequency_GHz, style, 4));
    if (source.assumed_object)
        words += ": the scene has no [object] with mass and distance.";
    else if (source.assumed_place)
        words += ", at the place of M87* in the sky.";
    if (source.rough) words += " The camera is near, moves or looks aside: the scale is rough.";
    return words;
}

// What is left of the light in the curve's minimum.
std::string least_words(const LiveTelescope& telescope, const NumberStyle& style) {
    constexpr double kLeast_percent = 0.01;  // pixels are no better
    const double least = telescope.view().minimum->amplitude;
    const double percent = 100 * least / telescope.view().amplitudes.front();
    if (percent < kLeast_percent) return "below 0.01 %";
    return telescope.source().unit ? number_words(least, style, 2) + " Jy" : number_words(percent, style, 2) + " %";
}

}  // namespace

void TelescopePanel::look(const Painting& painting, int number) {
    number_ = number;
    if (!painting.job.light) return;  // it was asked for before the panel was opened
    if (painting.light.empty()) {
        refusal_ = "A split screen has no light of one object.";
        return;
    }
    if (!telescope_) {
        auto stations = usual_array();
        if (!stations) {
            refusal_ = stations.error().message();
            return;
        }
        telescope_.emplace(std::move(*stations));
    }
    scene_ = small_scene(painting.job.scene, std::max(painting.light.width, painting.light.height));
    const Status looked = telescope_->look(scene_, painting.light, painting.coarse());
    refusal_ = looked ? "" : looked.error().message();
}

void TelescopePanel::show_through() {
    if (shown_changes_ == telescope_->changes()) return;
    shown_changes_ = telescope_->changes();
    const Image<float>& plane = telescope_->view().plane;
    plane_ = gl::make_rgba8_texture(plane.width, plane.height, plane_picture(plane).data.data());
    gl::set_linear(plane_);
    const auto beam = telescope_->beam();
    seen_ = {};
    if (!beam) return;
    const Image<unsigned char> picture =
        display_encoded(telescope_->through(*beam), scene_.camera.exposure_ev, scene_.picture);
    std::vector<unsigned char> rgba;
    for (int y = picture.height - 1; y >= 0; --y)  // from below
        for (int x = 0; x < picture.width; ++x) {
            const unsigned char* p = picture.at(x, y);
            rgba.insert(rgba.end(), {p[0], p[1], p[2], 255});
        }
    texture_ = gl::make_rgba8_texture(picture.width, picture.height, rgba.data());
    seen_ = {texture_.id(), picture.width, picture.height};
}

void TelescopePanel::draw_wishes(const PanelPlace& place) {
    TelescopeWish wish = telescope_->wish();
    row("Picture", kSeenHelp);
    choice("##seen", kSeenNames[static_cast<int>(wish.through)], place.escape, [&] {
        for (int i = 0; i < 3; ++i)
            if (choice_item(kSeenNames[i], i == static_cast<int>(wish.through)))
                wish.through = static_cast<SeenThrough>(i);
    });
    if (wish.through == SeenThrough::kBeam) {
        slide("Beam", wish.beam_uas, 1.0, 60.0,
              "%.1f \xc2\xb5"
              "as",
              "Full width at half of the maximum: of an ellipse the longer one.");
        slide("Axis ratio", wish.beam_ratio, 0.2, 1.0, "%.2f", "The shorter width over the longer one: 1 is round.");
        if (wish.beam_ratio < 1.0)
            slide("Beam angle", wish.beam_angle_deg, -90.0, 90.0, "%.0f\xc2\xb0",
                  "Of the longer axis, from north (up) through east (left).");
    }
    slide("Baselines to", wish.longest_glambda, 0.5, 100.0, "%.1f G\xce\xbb", kLongestHelp, Scale::kLogarithmic);
    slide("Direction", wish.angle_deg, 0.0, 180.0, "%.0f\xc2\xb0",
          "Of the curve's baselines, from north (up) through east (left).");
    telescope_->want(wish);
}

void TelescopePanel::draw_found(const PanelPlace& place) {
    const NumberStyle& style = place.view.numbers;
    const LiveView& view = telescope_->view();
    const float width = ImGui::GetContentRegionAvail().x;
    draw_amplitudes(*telescope_, style, {width, kCurveHeight * em()});
    constexpr double kDeep = 0.3;  // of all light
    text_row("Minimum",
             "The first one of |V| on this line, and how much of the light is left there: nothing at a ring's null.");
    const double length = view.minimum ? std::hypot(view.minimum->baseline.u, view.minimum->baseline.v) : 0.0;
    if (view.minimum)
        ImGui::TextUnformatted(
            fmt::format("{} G\xce\xbb: {}", number_words(1e-9 * length, style, 4), least_words(*telescope_, style))
                .c_str());
    else
        ImGui::TextDisabled("none on these baselines");
    text_row("As a ring", "How wide a thin ring is whose null is there: 0.7655 over the baseline.");
    if (view.minimum && view.minimum->amplitude < kDeep * view.amplitudes.front())
        ImGui::TextUnformatted((number_words(0.76547 / length / kUas, style, 4) + " \xc2\xb5"
                                                                                  "as across")
                                   .c_str());
    else
        ImGui::TextDisabled("not like one");
    TelescopeWish wish = telescope_->wish();
    const auto& triangles = telescope_->triangles();
    row("Triangle",
        "Three stations of the Event Horizon Telescope of 2017, whose closure phase is shown below and whose "
        "baselines are the orange tracks.");
    choice("##triangle", wish.triangle < triangles.size() ? telescope_->triangle_words(wish.triangle) : "none",
           place.escape, [&] {
               for (std::size_t i = 0; i < triangles.size(); ++i)
                   if (choice_item(telescope_->triangle_words(i), i == wish.triangle)) wish.triangle = i;
           });
    telescope_->want(wish);
    show_through();
    draw_tracks(*telescope_, plane_, kPlaneSide * em());
    tooltip(
        "The (u, v) plane up to the longest baseline, east left: |V| in grey, and the array's tracks as the Earth "
        "turns.");
    ImGui::SameLine();
    draw_closure(*telescope_, style, {ImGui::GetContentRegionAvail().x, kPlaneSide * em()});
    tooltip(
        "Closure phase of the triangle, from -180 to 180 degrees: through a day of Greenwich sidereal time, or, "
        "where the scene's time goes on, against its hours, as of the middle of those in which the stations see the "
        "source.");
}

void TelescopePanel::draw(PanelPlace& place) {
    const FrameFacts& facts = place.facts;
    if (facts.painting.texture != 0 && number_ != facts.number) look(facts.painting, facts.number);
    const float margin = kPanelMargin * em();
    const bool low = is_open(place.view, kHistogramPanel);  // which has the upper corner
    constexpr float kLeastWidth = 17.0f;  // of the font's size: beside the side panel where that is wide
    const float room = place.right - place.left - 2.0f * margin, width = std::min(kTelescopeWidth * em(), room);
    const bool fits = width >= kLeastWidth * em();
    const ImVec2 size{fits ? width : kTelescopeWidth * em(), std::max(place.bottom - place.top - 2.0f * margin, 1.0f)};
    const float right = fits ? place.right : ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos({right - margin, low ? place.bottom - margin : place.top + margin}, ImGuiCond_Always,
                            {1.0f, low ? 1.0f : 0.0f});
    ImGui::SetNextWindowSizeConstraints({size.x, 0.0f}, size);
    if (ImGui::Begin("Telescope", &place.open,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        if (telescope_ && refusal_.empty() && telescope_->has_light()) {
            draw_wishes(place);
            draw_found(place);
            paragraph(source_words(telescope_->source(), telescope_->linear(), place.view.numbers));
        } else {
            seen_ = {}, shown_changes_ = -1;
            paragraph(!refusal_.empty() ? refusal_ : telescope_ ? "The picture is dark." : "No picture yet.");
        }
    }
    ImGui::End();
    const auto beam = seen_.texture != 0 ? telescope_->beam() : std::nullopt;
    if (!beam) return;
    const double per_rad = ImGui::GetIO().DisplaySize.x / (scene_.camera.width * telescope_->source().pixel);
    const auto half = static_cast<float>(0.5 * per_rad * beam->major);
    draw_beam(*ImGui::GetBackgroundDrawList(), {place.left + 2.0f * margin + half, place.bottom - 2.0f * margin - half},
              *beam, per_rad);
}

const Panel kTelescopePanel{
    .menu = "View",
    .name = "Telescope",
    .keys = "T",
    .key = GLFW_KEY_T,
    .words = "what telescopes measure of it",
    .help =
        "Visibilities of the picture's light, tracks and closure phases of the Event Horizon Telescope, and the "
        "picture through its beam.",
    .hides_picture = true,
    .why_not = [](const ViewState& view) -> std::string { return view.scene.split ? "Not of a split screen" : ""; },
    .draw = [](PanelPlace& place) { place.parts.telescope.draw(place); },
    .forget = [](PanelParts& parts) { parts.telescope = {}; },
};

}  // namespace nullscope::viewer
