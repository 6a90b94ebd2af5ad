// What the viewer does with files: scenes, films and settings.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/atomic_file.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_writer.h"
#include "viewer/panel_rows.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

constexpr int kFilmFrames = 2;  // drawn anew when a film has got on

}  // namespace

bool Viewer::open_dropped(const Input& input) { return !input.dropped.empty() && open_file(input.dropped.back()); }

bool Viewer::open_chosen() {
    if (std::exchange(gallery_.browse_pressed, false) && !files_.dialog.runs())
        if (const Status asked = files_.dialog.open(); !asked) say(asked.error().message());
    const std::string file = files_.dialog.poll();
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
    Scene scene = flight_.timeline.to_save(view_.scene);
    set_size(scene, view_.loaded.camera.width, view_.loaded.camera.height);
    auto checked = savable(scene);
    if (!checked) return say("Not saved: " + checked.error().message());
    scene = std::move(*checked);
    if (Status saved = write_text_atomically(path, kSavedMark + scene_file_text(scene, path.parent_path())); !saved)
        return say(saved.error().message());
    history_.rest(view_);  // as what it was until now
    history_.saved(view_.source, path.string());
    view_.source = shown_.view.source = path.string();
    view_.loaded = scene;
    own_file(view_, view_.source);
    say(fmt::format("Saved {}", view_.source));
}

bool Viewer::offer_left_scene() {
    bool restored = false;
    std::error_code error;
    switch (draw_left_scene(*files_.left)) {
        case LeftScene::kWaits: return false;
        case LeftScene::kDiscarded: std::filesystem::remove(*files_.left, error); break;
        case LeftScene::kRestored:
            if (Status taken = take_left_scene(*files_.left); !taken)
                say(taken.error().message());
            else
                restored = open_file(last_session().string());
            break;
    }
    files_.left = left_scene();
    return restored;
}

// The scene's path may be new, or gone.
void Viewer::follow_path() {
    if (const auto has_path = flight_.follow(view_)) set_open(view_, kTimelinePanel, *has_path);
}

void Viewer::sample_flight() {
    if (!flight_.timeline.records()) return;
    if (!flight_.sample(view_.scene, seconds())) say("Observer changed: the recording starts again here");
    pace_.want(1);  // the button shows the time
}

void Viewer::follow_film() {
    if (!panels_.timeline.refusal.empty()) say(std::exchange(panels_.timeline.refusal, {}));
    if (const auto wish = std::exchange(panels_.timeline.film_wish, std::nullopt)) {
        Scene scene = flight_.timeline.to_save(view_.scene);
        view_.hidden.leave_out(scene);
        set_size(scene, wish->width, wish->height);
        if (Status started = flight_.film.start(scene, std::filesystem::absolute(wish->output).string()); !started)
            say(started.error().message());
    }
    if (!flight_.film.poll()) return;
    pace_.want(kFilmFrames);
    if (const std::string message = flight_.film.take_message(); !message.empty()) say(message);
}

void Viewer::keep_settings() {
    if (patient()) return;
    settings_.now.light_theme = view_.light_theme;
    settings_.now.numbers = view_.numbers;
    settings_.now.recent.assign(view_.own.begin(),
                                view_.own.begin() + std::min(view_.own.size(), Settings::kMostRecent));
    if (Status saved = settings_.keep(); !saved) say(saved.error().message());
}

}  // namespace nullscope::viewer
