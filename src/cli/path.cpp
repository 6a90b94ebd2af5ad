// nullscope path: the cameras of a scene's path as a table.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "command/arguments.h"
#include "observer/path.h"
#include "scenefile/path_csv.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {
namespace {

struct PathOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, range, output = "path.csv";
    bool cartesian = false;
};

Status run_path(const PathOptions& options) {
    TRY(scene, asked_scene(options));
    TRY(path, CameraPath::make(*scene));
    TRY(frames, parse_frames(options.range.empty() ? fmt::format("0:{}", path->frames()) : options.range));
    const int count = frames->end - frames->first;
    if (frames->end > path->frames() || count < 2 || count > static_cast<int>(kMostPathRows))
        return bad_input(fmt::format("frames {}:{} of a path of {}", frames->first, frames->end, path->frames()),
                         fmt::format("two or more of 0:{}{}", path->frames(),
                                     path->frames() > static_cast<int>(kMostPathRows)
                                         ? fmt::format(", at most {} at once", kMostPathRows)
                                         : ""));
    std::vector<PathKey> keys;
    for (int frame = frames->first; frame < frames->end; ++frame)
        keys.push_back({static_cast<double>(frame), path->at(frame), path->clock(frame)});
    TRY(text, path_csv(keys, options.cartesian ? PathPlaces::kCartesian : PathPlaces::kSpherical));
    TRY(written, write_text_atomically(options.output, *text));
    fmt::print("{}: {} frames\n", options.output, count);
    return Done{};
}

}  // namespace

void add_path(Command& parent) {
    auto [command, options] = add_command<PathOptions>(
        parent, "path", "Write the camera of every frame of a [path] as a table (CSV), which path.file reads",
        run_path);
    required_option(command, "scene", options.scene, "Scene file, or the name of a built-in scene, with a [path]");
    set_option(command, options.set);
    command.add_option("frames", &options.range, "A:B, frames A to B-1 (default: all)");
    text_option(command, "-o,--output", options.output, "File to write");
    command.add_flag("--cartesian", &options.cartesian, "Write positions as x, y, z instead of r, theta, phi");
}

}  // namespace nullscope::cli
