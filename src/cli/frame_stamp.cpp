#include "cli/frame_store.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/image_file.h"
#include "scene/medium_dumps.h"
#include "scenefile/scene_text.h"

namespace nullscope::cli {
namespace {

void append_scene(std::string& text, const std::string& prefix, const Scene& scene) {
    for (const SceneLine& line : scene_lines(scene)) {
        const bool dumps = line.name == "medium.file" && has_dumps(scene);
        text += fmt::format("{}{} = {}\n", prefix, line.name,
                            dumps               ? dumps_stamp(scene.medium->grid)
                            : line.file.empty() ? line.value
                                                : contents_of(line.file));
    }
}

// The names of the lines of `text` that `other` does not have, added to names.
void add_names(const std::string& text, const std::string& other, std::vector<std::string>& names) {
    const auto lines = split(other, '\n');
    const std::set<std::string> known(lines.begin(), lines.end());
    for (const std::string& line : split(text, '\n')) {
        const std::string name = without_controls(line.substr(0, line.find(" = ")));
        if (known.contains(line) || std::find(names.begin(), names.end(), name) != names.end()) continue;
        names.push_back(name);
    }
}

}  // namespace

std::string frame_stamp(const StampInput& input) {
    const CaptureOptions& options = input.options;
    const std::string kind = options.output.substr(std::min(options.output.rfind('.'), options.output.size()));
    std::string text = fmt::format("program version = {}\n", input.version);
    text += fmt::format("kind of file = {}\n", options.to_film() ? ".png" : kind);
    text += fmt::format("--raydata = {}\n", options.raydata);
    if (!options.derivatives.empty()) text += fmt::format("--derivatives = {}\n", options.derivatives);
    text += fmt::format("--layers = {}\n--st-map = {}\n", options.layers, options.st_map);
    text += fmt::format("--half = {}\n", options.half);
    text += fmt::format("--quality = {}\n", options.quality.value_or(kJpegQuality));
    if (options.bits == "10" || options.bits == "16") text += fmt::format("--bits = {}\n", options.bits);
    if (options.colour != CaptureOptions{}.colour) text += fmt::format("--colour = {}\n", options.colour);
    text += fmt::format("--plain = {}\n", options.plain);
    text += fmt::format("--renderer = {}\n", options.renderer);
    if (options.renderer == "reference") {
        text += fmt::format("--samples = {}\n", options.samples.value_or(kSamples));
    } else {
        text += fmt::format("--context = {}\n--method = {}\n", options.context.kind, input.method);
        text += fmt::format("--tiles = {}\n", options.tiles);
        if (options.stage != CaptureOptions{}.stage) text += fmt::format("--stage = {}\n", options.stage);
        text += fmt::format("--largest-texture = {}\n", options.largest_texture.value_or(0));
    }
    text += fmt::format("--time-step = {:.17g}\ntime of frame 0 = {:.17g}\n", options.time_step, input.first_time);
    append_scene(text, "", input.scene);
    if (input.split != nullptr) append_scene(text, "--split ", *input.split);
    return text;
}

std::string stamp_difference(const std::string& before, const std::string& now) {
    constexpr std::size_t kMostNames = 3;
    if (before.empty()) return "they have no stamp";
    std::vector<std::string> names;
    add_names(now, before, names);
    add_names(before, now, names);
    if (names.empty()) return "their lines are in another order";
    const std::size_t shown = std::min(names.size(), kMostNames);
    const std::string more = names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "";
    names.resize(shown);
    return fmt::format("different {}{}", fmt::join(names, ", "), more);
}

}  // namespace nullscope::cli
