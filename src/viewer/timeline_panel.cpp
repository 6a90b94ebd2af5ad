#include "viewer/timeline_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "platform/places.h"
#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

struct FilmSize {
    const char* words;
    int width, height;  // 0: the window's
};
constexpr std::array kSizes = {FilmSize{"the window's", 0, 0}, FilmSize{"640 x 360", 640, 360},
                               FilmSize{"1280 x 720", 1280, 720}, FilmSize{"1920 x 1080", 1920, 1080},
                               FilmSize{"3840 x 2160", 3840, 2160}};
constexpr double kSlowest = 0.1, kFastestPlayed = 10.0;

}  // namespace

bool TimelinePanel::draw(ViewState& view, Timeline& timeline, FilmExport& film, float left, float bottom, bool escape) {
    const float margin = 0.6f * em(), screen = ImGui::GetIO().DisplaySize.x;
    if (screen - left < 20.0f * em()) left = margin;
    ImGui::SetNextWindowPos({left, bottom - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSize({screen - left - margin, 0.0f});
    bool changed = false;
    if (ImGui::Begin("Timeline##timeline", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize)) {
        changed |= draw_slider(view, timeline);
        changed |= draw_buttons(view, timeline);
        draw_film(view, film, escape);
        height_ = ImGui::GetWindowHeight();
    }
    ImGui::End();
    return changed;
}

bool TimelinePanel::draw_slider(ViewState& view, Timeline& timeline) {
    if (!timeline.has_path()) {
        paragraph(timeline.records() ? "Recording: fly, turn, fall. Stop makes a path of it."
                                     : "No path yet: record a flight, or set keys of one.");
        return false;
    }
    const double last = timeline.frames() - 1.0, rate = view.scene.path->rate;
    double frame = timeline.frame;
    const double first = 0.0;
    const std::string words = fmt::format("{:.2f} of {:.2f} s, frame {:.0f}", frame / rate, last / rate, frame);
    ImGui::SetNextItemWidth(-1.0f);
    const bool moved = ImGui::SliderScalar("##frame", ImGuiDataType_Double, &frame, &first, &last, words.c_str(),
                                           ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
    // Keys as ticks below the slider.
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    for (const PathKey& key : view.scene.path->keys) {
        const double at = frame_of_key(*view.scene.path, key.frame);
        const float x = from.x + static_cast<float>(std::clamp(at / last, 0.0, 1.0)) * (to.x - from.x);
        ImGui::GetWindowDrawList()->AddLine({x, to.y - 0.3f * em()}, {x, to.y}, ImGui::GetColorU32(ImGuiCol_CheckMark),
                                            1.5f);
    }
    if (!moved) return false;
    timeline.play(false);
    timeline.seek(view.scene, frame);
    return true;
}

bool TimelinePanel::draw_buttons(ViewState& view, Timeline& timeline) {
    bool changed = false;
    auto button = [first = true](const char* name, const char* help) mutable -> bool {
        if (!std::exchange(first, false)) next_to(button_width(name));
        const bool pressed = ImGui::Button(name);
        tooltip(help);
        return pressed;
    };
    if (timeline.has_path() && button(timeline.plays() ? "Pause" : "Play", "Plays the path (key L)."))
        timeline.play(!timeline.plays());
    const std::string record =
        timeline.records() ? fmt::format("Stop {:.1f} s###record", timeline.recorded_s()) : "Record###record";
    if (button(record.c_str(), "Records the camera from now on as a path, until it is pressed again (F9)."))
        record_pressed = true;
    if (button("Set key", "The path goes through the present camera at this frame.") &&
        !(changed = timeline.set_key(view.scene)))
        refusal = "A key is set only on a path of keys, by an observer of the same kind (path.kind, camera.observer)";
    if (timeline.has_path() && !view.scene.path->keys.empty()) {
        if (button("Delete key", "Deletes the key nearest to this frame.")) changed |= timeline.delete_key(view.scene);
    }
    if (timeline.has_path()) {
        if (button("Film...", "Draws the path as a film, or as frames, while the viewer goes on."))
            ImGui::OpenPopup("##film");
        if (!view.scene.path->keys.empty() && !view.scene.path->closed) {
            bool smooth = view.scene.path->easing == PathEasing::kSmooth;
            next_to(button_width("Ease") + ImGui::GetFrameHeight());
            changed |= ImGui::Checkbox("Ease", &smooth);
            tooltip("The motion starts and ends at rest (path.easing).");
            view.scene.path->easing = smooth ? PathEasing::kSmooth : PathEasing::kNone;
        }
        next_to(button_width("Loop") + ImGui::GetFrameHeight());
        ImGui::Checkbox("Loop", &timeline.loops);
        next_to(3.8f * em());
        ImGui::SetNextItemWidth(3.8f * em());
        ImGui::SliderScalar("##speed", ImGuiDataType_Double, &timeline.speed, &kSlowest, &kFastestPlayed, "%.2g x",
                            ImGuiSliderFlags_Logarithmic);
        tooltip("Speed of playing; films have the path's own.");
    }
    return changed;
}

void TimelinePanel::draw_film(const ViewState& view, FilmExport& film, bool escape) {
    if (film.runs()) {
        ImGui::ProgressBar(static_cast<float>(film.share()), {-6.0f * em(), 0.0f}, film.progress_words().c_str());
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) {
            film.cancel();
            refusal = "Film cancelled; frames that were drawn stay, and the same film goes on from there";
        }
    }
    if (!ImGui::BeginPopup("##film")) return;
    if (escape) ImGui::CloseCurrentPopup();
    if (name_.empty()) name_ = view.scene.name;
    ImGui::SetNextItemWidth(16.0f * em());
    input_text("##name", "Name", name_);
    tooltip("Of the file, in the folder where the viewer was started; or a whole path.");
    ImGui::SetNextItemWidth(16.0f * em());
    choice("##size", kSizes[static_cast<std::size_t>(size_)].words, escape, [&] {
        for (std::size_t i = 0; i < kSizes.size(); ++i)
            if (choice_item(kSizes[i].words, static_cast<int>(i) == size_)) size_ = static_cast<int>(i);
    });
    const bool films = platform::is_in_path("ffmpeg");
    bool frames = frames_ || !films;
    ImGui::BeginDisabled(!films);
    if (ImGui::Checkbox("Frames (.png), not a film (.mp4)", &frames)) frames_ = frames;
    ImGui::EndDisabled();
    if (!films) paragraph("A film needs ffmpeg, which is not installed.");
    paragraph(fmt::format("{} frames, into {}", view.scene.path ? view.scene.path->frames : 0,
                          std::filesystem::absolute(name_).parent_path().string()));
    if (ImGui::Button("Draw") && !name_.empty()) {
        const FilmSize& size = kSizes[static_cast<std::size_t>(size_)];
        film_wish =
            FilmWish{name_ + (frames ? "-%05d.png" : ".mp4"), size.width > 0 ? size.width : view.scene.camera.width,
                     size.height > 0 ? size.height : view.scene.camera.height};
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

namespace {

void draw_timeline(PanelPlace& place) {
    TimelinePanel& panel = place.parts.timeline;
    place.changed |=
        panel.draw(place.view, place.flight.timeline, place.flight.film, place.left, place.bottom, place.escape);
    place.bottom -= panel.height();
    place.gap = panel.height() > 0.0f ? kStripGap * em() : 0.0f;
}

}  // namespace

const Panel kTimelinePanel{
    .menu = "View",
    .name = "Timeline",
    .keys = "Ctrl+T",
    .key = GLFW_KEY_T,
    .control = true,
    .words = "the scene's path: play, keys, films",
    .where = Panel::Where::kDocked,
    .escapes = false,
    .needed = [](const PanelPlace& place) { return place.flight.timeline.records() || place.flight.film.runs(); },
    .draw = draw_timeline,
    .forget = [](PanelParts& parts) { parts.timeline.forget(); },
};

}  // namespace nullscope::viewer
