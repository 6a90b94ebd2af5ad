#include "cli/recorded_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "cli/frame_store.h"
#include "cli/option_rules.h"
#include "image/image_file.h"
#include "plan/frame_plan.h"
#include "scenefile/picture_scene.h"

namespace nullscope::cli {
namespace {

using Names = std::vector<std::string_view>;

bool names_one(const Names& names, std::string_view option) { return std::ranges::find(names, option) != names.end(); }

// Which of what is recorded the new picture does not take over, because of what was given.
Names displaced(const CaptureOptions& options, const Names& given) {
    Names out = given;
    const auto drop = [&](const Names& names) { out.insert(out.end(), names.begin(), names.end()); };
    for (const std::string_view option : given) drop(excluded_by(option));
    if (names_one(out, "--renderer")) drop({"--samples"});  // recorded of that renderer
    if (names_one(given, "--frames") || options.to_film()) drop({"--frames", "--time-step", "--time-frame"});
    return out;
}

}  // namespace

std::string recorded_options(const RunOptions& run, const Scene& scene) {
    const CaptureOptions& options = run.options;
    std::vector<std::string> words;
    const auto add = [&](const char* name, const auto& value) { words.push_back(fmt::format("{} {}", name, value)); };
    if (options.renderer == "reference") {
        add("--renderer", options.renderer), add("--samples", options.samples.value_or(kSamples));
    } else {
        const bool mino = light_path_kind(effect_set(required_effects(scene))) == LightPathKind::kMino;
        if (!(mino && run.method == Method{})) add("--method", method_name(run.method));
        if (run.traced_tiles) add("--tiles", *run.traced_tiles ? "traced" : "bodies");
        if (options.stage != CaptureOptions{}.stage) add("--stage", options.stage);
        if (options.largest_texture) add("--largest-texture", *options.largest_texture);
    }
    if (options.half) words.emplace_back("--half");
    if (options.raydata) words.emplace_back("--raydata");
    if (!options.derivatives.empty()) add("--derivatives", options.derivatives);
    if (options.layers) words.emplace_back("--layers");
    if (!options.st_map.empty()) add("--st-map", options.st_map);
    if (options.format_has("--quality")) add("--quality", options.quality.value_or(kJpegQuality));
    if (options.words_asked() && (options.to_film() || options.format()->sample != Sample::kWord))
        add("--bits", run.frame ? "16" : options.bits);  // a film's picture has them all
    if (options.to_exr() && options.colour != CaptureOptions{}.colour) add("--colour", options.colour);
    if (options.plain && !options.to_linear_light()) words.emplace_back("--plain");
    if (run.frame) words.push_back(fmt::format("--frames {}:{}", *run.frame, *run.frame + 1));
    if (run.whole_film && options.time_step != 0) add("--time-step", options.time_step);
    if (run.whole_film && run.frame && !scene.path) add("--time-frame", run.time_frame);
    return fmt::format("{}", fmt::join(words, " "));
}

Result<CaptureOptions> with_recorded(CaptureOptions options, const OpenedScene& picture, const Note& note) {
    if (options.split.empty() && picture.words.contains(kSplitWord))
        options.split = options.scene, options.split_is_recorded = true;
    const auto text = picture.words.find(kOptionsWord);
    if (text == picture.words.end()) return options;
    CaptureOptions recorded;
    Command command("capture", ""), ours("capture", "");
    add_capture_options(command, recorded), add_capture_options(ours, options);
    std::vector<std::string> words = {"capture", "scene"};
    for (std::string& word : split(text->second, ' ')) words.push_back(std::move(word));
    std::vector<const char*> arguments;
    arguments.reserve(words.size());
    for (const std::string& word : words) arguments.push_back(word.c_str());
    command.note_given(&recorded.given);
    if (const auto asked = parse_command_line(command, static_cast<int>(arguments.size()), arguments.data()); !asked)
        return bad_input(
            without_controls(fmt::format("{}: {}: {}", options.scene, kOptionsWord, asked.error().message())));

    const Names out = displaced(options, {options.given.begin(), options.given.end()}), lost = without_place(options);
    static constexpr std::array<std::string_view, 21> kRecorded = {
        "--renderer",  "--samples", "--method",      "--tiles",  "--stage",     "--largest-texture",
        "--half",      "--raydata", "--derivatives", "--layers", "--st-map",    "--quality",
        "--plain",     "--frames",  "--size",        "--time",   "--time-step", "--time-frame",
        "--max-error", "--bits",    "--colour"};
    std::vector<std::string_view> left_out;
    for (std::size_t i = 0; i < command.options().size(); ++i) {
        const Option& option = *command.options()[i];
        const bool known = std::ranges::find(kRecorded, option.names) != kRecorded.end();
        if (!known || !names_one({recorded.given.begin(), recorded.given.end()}, option.names) ||
            names_one(out, option.names))
            continue;
        if (!names_one(lost, option.names))
            copy_value(option, *ours.options()[i]);
        else if (option.names != "--quality" && option.names != "--bits")
            left_out.push_back(option.names);
    }
    options.one_frame = !options.frames.empty() && !names_one(out, "--frames") && !names_frames(options.output);
    if (!left_out.empty())
        note(fmt::format("{}: recorded options are left out, only an .exr has them: {}",
                         without_controls(options.scene), fmt::join(left_out, ", ")));
    return options;
}

}  // namespace nullscope::cli
