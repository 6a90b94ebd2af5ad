// The options of capture that a picture's words record, so that it is drawn again from itself.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "cli/capture_options.h"
#include "scene/scene.h"
#include "scenefile/scene_file.h"
#include "shaderlib/method.h"

namespace nullscope::cli {

// What of a run is not in the scene that its pictures hold.
struct RunOptions {
    const CaptureOptions& options;
    Method method;                       // that auto chose
    std::optional<bool> traced_tiles{};  // where there is a disc: worth_tiles()
    std::optional<int> frame{};          // of a sequence or film
    bool whole_film = false;             // the scene is that of all frames: of blur, of motion vectors
    int time_frame = 0;                  // that has its time
};

// As words of the command line: those that change the picture, "--method mino:6:0.6 --tiles bodies".
std::string recorded_options(const RunOptions& run, const Scene& scene);

// The options with what a picture recorded where they were not given. Recorded ones that the new file cannot have are left out, and said to note.
// Errors (bad input): the words are none of capture's.
Result<CaptureOptions> with_recorded(CaptureOptions options, const OpenedScene& picture, const Note& note);

}  // namespace nullscope::cli
