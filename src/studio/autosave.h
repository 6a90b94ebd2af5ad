// Scenes that were changed and not saved, kept in the state folder: after a crash one goes on, and after an ordinary end as well.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::viewer {

class Autosave {
public:
    // Writes the scene if it has changed since the last time, at most every kInterval_s; removes what was written if it is as `loaded` again.
    // now: seconds of a steady clock. Cost: 0.3 ms where something has changed, and a file's writing; nothing until kInterval_s is over.
    // Errors: it cannot be written; it is said once.
    Status keep(const Scene& scene, const Scene& loaded, double now);
    // The viewer ends as it should: what was not saved becomes the last session.
    void end(const Scene& scene, const Scene& loaded);

    static constexpr double kInterval_s = 2.0;

private:
    Status write(const Scene& scene, const Scene& loaded);
    double kept_at_ = -kInterval_s;
    std::string text_;  // that is in the file; empty: there is none
    bool failed_ = false;
};

// The newest scene of a viewer that did not end as it should; nothing if there is none. Those of viewers that run are left alone.
std::optional<std::filesystem::path> left_scene();
// Makes it the last session, to be opened from there.
Status take_left_scene(const std::filesystem::path& file);

// A recorded flight that another scene replaces, with its scene, to be opened after the viewer has ended, too.
Status keep_recording(const Scene& scene);
// A scene that was pasted, to be opened from there. Errors: it cannot be written, there is no home.
Status keep_pasted(const Scene& scene);

// Their files, whether they are there or not; empty without a home.
std::filesystem::path last_session();
std::filesystem::path last_recording();
std::filesystem::path last_pasted();

}  // namespace nullscope::viewer
