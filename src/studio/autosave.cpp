#include "studio/autosave.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <utility>

#include "base/atomic_file.h"
#include "platform/process.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_writer.h"
#include "studio/user_files.h"
#include "studio/view_state.h"

namespace nullscope::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kAutosavePrefix = "unsaved-";

fs::path state_file(const std::string& name) {
    const fs::path folder = state_folder();
    return folder.empty() ? folder : folder / name;
}

fs::path own_file_of(int process) { return state_file(fmt::format("{}{}.toml", kAutosavePrefix, process)); }

// The process that a file belongs to, or 0.
int process_of(const fs::path& file) {
    const std::string stem = file.stem().string();
    if (!stem.starts_with(kAutosavePrefix) || file.extension() != ".toml") return 0;
    int process = 0;
    const char* end = stem.data() + stem.size();
    const auto [last, error] = std::from_chars(stem.data() + kAutosavePrefix.size(), end, process);
    return error == std::errc() && last == end ? process : 0;
}

// Size apart, which follows the window.
std::string text_of(Scene scene) {
    set_size(scene, CameraSpec{}.width, CameraSpec{}.height);
    return scene_file_text(scene, {});
}

Status keep(const fs::path& file, const Scene& scene) {
    TRY(good, savable(scene));
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    return write_text_atomically(file, text_of(*good));
}

}  // namespace

Status Autosave::keep(const Scene& scene, const Scene& loaded, double now) {
    if (now - kept_at_ < kInterval_s) return Done{};
    kept_at_ = now;
    Status written = write(scene, loaded);
    if (written) return written;
    return std::exchange(failed_, true) ? Status(Done{}) : written;
}

Status Autosave::write(const Scene& scene, const Scene& loaded) {
    const fs::path file = own_file_of(platform::process_id());
    if (file.empty()) return Done{};
    std::string text = text_of(scene);
    if (text == text_of(loaded)) text.clear();
    if (!text.empty() && text != text_)
        if (const auto good = savable(scene)) text = text_of(*good);
    if (text == text_) return Done{};
    std::error_code error;
    if (text.empty())
        fs::remove(file, error);
    else {
        fs::create_directories(file.parent_path(), error);
        TRY(written, write_text_atomically(file, text));
    }
    text_ = std::move(text);
    return Done{};
}

void Autosave::end(const Scene& scene, const Scene& loaded) {
    if (!write(scene, loaded) || text_.empty()) return;
    std::error_code error;
    fs::rename(own_file_of(platform::process_id()), last_session(), error);  // else it is offered as after a crash
}

std::optional<fs::path> left_scene() {
    std::optional<fs::path> newest;
    fs::file_time_type when;
    std::error_code error;
    for (fs::directory_iterator i(state_folder(), error), end; !error && i != end; i.increment(error)) {
        const int process = process_of(i->path());
        if (process <= 0 || platform::is_running(process)) continue;
        std::error_code unknown;
        const fs::file_time_type changed = i->last_write_time(unknown);
        if (unknown || (newest && changed <= when)) continue;
        newest = i->path(), when = changed;
    }
    return newest;
}

Status take_left_scene(const fs::path& file) {
    std::error_code error;
    fs::rename(file, last_session(), error);
    if (error) return failed(fmt::format("{}: {}", file.string(), error.message()));
    return Done{};
}

Status keep_recording(const Scene& scene) {
    return last_recording().empty() ? Status(Done{}) : keep(last_recording(), scene);
}

Status keep_pasted(const Scene& scene) {
    return last_pasted().empty() ? failed("HOME is not set, so there is no place for a pasted scene")
                                 : keep(last_pasted(), scene);
}

fs::path last_session() { return state_file("last-session.toml"); }
fs::path last_recording() { return state_file("last-recording.toml"); }
fs::path last_pasted() { return state_file("last-pasted.toml"); }

}  // namespace nullscope::viewer
