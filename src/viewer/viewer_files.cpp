// What the viewer does with files: scenes, films and settings.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/atomic_file.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_writer.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

constexpr int kFilmFrames = 2;  // drawn anew when a film has got on

}  // namespace

bool Viewer::open_dropped(const Input& input) { return !input.dropped.empty() && open_file(input.dropped.back()); }

bool Viewer::open_chosen() {
    if (std::exchange(gallery_.browse_pressed, false) && !file_dialog_.runs())
        if (const Status asked = file_dialog_.open(); !asked) say(asked.error().message());
    const std::string file = file_dialog_.poll();
    return !file.empty() && open_file(file);
}

bool Viewer::open_file(const std::string& file_or_name) {
    if (is_tour_file(file_or_name)) return open_tour(file_or_name);
    leave_scene();
    const Status opened = load_into(view_, file_or_name);
    if (!opened) say(std::exchange(view_.error, {}));
    if (opened && !view_.note.empty()) say(std::exchange(view_.note, {}));
    if (opened) gallery_.close();
    return static_cast<bool>(opened);
}

// Files with comments of somebody are not written over: they would be lost.
std::filesystem::path Viewer::usual_path() const {
    return may_be_replaced(view_.source) ? std::filesystem::path(view_.source) : fresh_scene_path(view_.scene.name);
}

void Viewer::save_scene() { save_scene_to(usual_path()); }

// Under a name that was chosen, which is the scene's from then on.
void Viewer::save_scene_as(const std::filesystem::path& path) {
    view_.scene.name = path.stem().string();
    save_scene_to(path);
    window_->set_title(view_.scene.name + kTitle);
}

void Viewer::save_scene_to(const std::filesystem::path& path) {
    Scene scene = timeline_.to_save(view_.scene);
    set_size(scene, view_.loaded.camera.width, view_.loaded.camera.height);
    auto checked = savable(scene);
    if (!checked) return say("Not saved: " + checked.error().message());
    scene = std::move(*checked);
    if (Status saved = write_text_atomically(path, kSavedMark + scene_file_text(scene, path.parent_path())); !saved)
        return say(saved.error().message());
    view_.source = shown_.source = path.string();
    view_.loaded = scene;
    own_file(view_, view_.source);
    say(fmt::format("Saved {}", view_.source));
}

bool Viewer::offer_left_scene() {
    bool restored = false;
    std::error_code error;
    switch (draw_left_scene(*left_)) {
        case LeftScene::kWaits: return false;
        case LeftScene::kDiscarded: std::filesystem::remove(*left_, error); break;
        case LeftScene::kRestored:
            if (Status taken = take_left_scene(*left_); !taken)
                say(taken.error().message());
            else
                restored = open_file(last_session().string());
            break;
    }
    left_ = left_scene();
    return restored;
}

// The scene's path may be new, or gone.
void Viewer::follow_path() {
    const bool had_path = timeline_.has_path();
    timeline_.follow(view_.scene, timeline_source_ != view_.source);
    if (timeline_.has_path() != had_path || timeline_source_ != view_.source)
        view_.show_timeline = timeline_.has_path();
    timeline_source_ = view_.source;
}

void Viewer::sample_flight() {
    if (!timeline_.records()) return;
    const double now = seconds();
    if (!timeline_.sample(view_.scene, now - sampled_at_)) say("Observer changed: the recording starts again here");
    sampled_at_ = now;
    frames_due_ = std::max(frames_due_, 1);  // the button shows the time
}

void Viewer::follow_film() {
    if (!timeline_panel_.refusal.empty()) say(std::exchange(timeline_panel_.refusal, {}));
    if (const auto wish = std::exchange(timeline_panel_.film_wish, std::nullopt)) {
        Scene scene = timeline_.to_save(view_.scene);
        view_.hidden.leave_out(scene);
        set_size(scene, wish->width, wish->height);
        if (Status started = film_.start(scene, std::filesystem::absolute(wish->output).string()); !started)
            say(started.error().message());
    }
    if (!film_.poll()) return;
    frames_due_ = kFilmFrames;
    if (const std::string message = film_.take_message(); !message.empty()) say(message);
}

void Viewer::keep_settings() {
    if (patient()) return;
    settings_.light_theme = view_.light_theme;
    settings_.numbers = view_.numbers;
    settings_.recent.assign(view_.own.begin(), view_.own.begin() + std::min(view_.own.size(), Settings::kMostRecent));
    if (settings_ == kept_settings_) return;
    kept_settings_ = settings_;
    if (Status saved = save_settings(settings_); !saved) say(saved.error().message());
}

}  // namespace nullscope::viewer
