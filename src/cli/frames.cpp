// nullscope frames: a sequence in chunks, each a command line for one of many machines.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "cli/capture.h"
#include "cli/capture_words.h"
#include "cli/frame_store.h"
#include "command/arguments.h"
#include "observer/path.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {
namespace {

struct FramesOptions {
    std::string scene, output = "frame%05d.png", range;
    Words more;  // capture's options; without a range the first of them is in its place
    int chunk = 10;
    bool commands = false;
};

Words capture_words(const FramesOptions& options, const Frames& frames, const Words& more) {
    Words words{"nullscope", "capture", options.scene, "--frames", fmt::format("{}:{}", frames.first, frames.end),
                "--resume",  "-o",      options.output};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// "0:10 15:18"; numbers: ascending.
std::string ranges_text(const std::vector<int>& numbers) {
    std::string text;
    for (std::size_t i = 0, end = 0; i < numbers.size(); i = end) {
        for (end = i + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) ++end;
        text += fmt::format("{}{}:{}", text.empty() ? "  " : " ", numbers[i], numbers[end - 1] + 1);
    }
    return text;
}

Status run_frames(const FramesOptions& options) {
    Words more = options.more;
    std::string range = options.range;
    if (range.starts_with('-')) {
        more.insert(more.begin(), range);
        range.clear();
    }
    TRY(scene, load_scene(options.scene));
    if (range.empty()) {
        if (!scene->path) return bad_input("no [path] in the scene: give the frames as A:B, and -- --time-step DT");
        TRY(path, CameraPath::make(*scene));
        range = fmt::format("0:{}", path->frames());
    }
    TRY(frames, parse_frames(range));
    if (!scene->path) more.insert(more.end(), {"--time-frame", fmt::format("{}", frames->first)});  // of all chunks
    const Words all = capture_words(options, *frames, more);
    TRY(line, shell_line(all));
    TRY(capture, capture_options_of(all));
    TRY(stamp, sequence_stamp(*capture));
    const int count = frames->end - frames->first;
    if (!options.commands) {
        TRY(names, FrameNames::parse(options.output));
        std::vector<int> there = names->on_disk();
        std::erase_if(there, [&](int frame) { return frame < frames->first || frame >= frames->end; });
        fmt::print("frames  {:>8}  {}\n", count, range);
        fmt::print("chunks  {:>8}  of {}\n", (count - 1) / options.chunk + 1, options.chunk);
        const auto before = read_text(names->stamp_file());
        const bool other = !there.empty() && !(before && *before == *stamp);
        fmt::print("there   {:>8}{}\n", other ? 0 : there.size(), other ? "" : ranges_text(there));
        if (other)
            fmt::print("other   {:>8}{}  {}\n", there.size(), ranges_text(there),
                       stamp_difference(before ? *before : "", *stamp));
        return Done{};
    }
    for (int first = frames->first; first < frames->end; first += std::min(options.chunk, frames->end - first)) {
        TRY(chunk,
            shell_line(capture_words(options, {first, first + std::min(options.chunk, frames->end - first)}, more)));
        fmt::print("{}\n", *chunk);
    }
    return Done{};
}

}  // namespace

void add_frames(Command& parent) {
    auto [command, options] = add_command<FramesOptions>(
        parent, "frames", "Divide a sequence into chunks that several machines draw at once (docs/farm.md)",
        run_frames);
    required_option(command, "scene", options.scene, "Scene file, or the name of a built-in scene");
    command.add_option("frames", &options.range, "A:B, frames A to B-1 (default: all of the scene's [path])");
    command.add_option("options", &options.more, "After --: options of capture, as in -- --size 640x360");
    text_option(command, "-o,--output", options.output,
                "Files to write, as for capture, with one placeholder for the frame number");
    number_option(command, "--chunk", options.chunk, 1, 1000000, "Frames of a chunk");
    command.add_flag("--commands", &options.commands,
                     "Print a shell command for each chunk; run again, it draws only missing frames");
}

}  // namespace nullscope::cli
