// What the pictures of a film or a sequence depend on, as text: pictures of two runs may stand in one film only if it is
// equal.
#pragma once
#include <string>

#include "cli/capture_options.h"
#include "scene/scene.h"

namespace nullscope::cli {

struct StampInput {
    const Scene& scene;   // with the size and the time that are drawn
    const Scene* beside;  // of the right half; null where the picture is one scene's, or the scene names it
    const CaptureOptions& options;
    std::string method;   // that auto chose
    double first_time;    // of frame 0
    std::string version;  // of the program
};

// One line for everything: options, every member of the scenes, the contents of the image files that they name.
std::string frame_stamp(const StampInput& input);

// The names of the lines that differ between two stamps, as a message says it: "camera.r, sky.kind and 2 more".
std::string stamp_difference(const std::string& before, const std::string& now);

}  // namespace nullscope::cli
