#include "cli/capture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "cli/frame_store.h"
#include "command/options.h"
#include "image/image_file.h"
#include "scenefile/scene_keys.h"
#include "shaderlib/frontier.h"

namespace nullscope::cli {

namespace {

// "a .png (8 bits, display-ready), ..."
std::string format_help() {
    std::string help;
    for (const PictureFormat* format : kPictureFormats)
        help += fmt::format("{}a {} ({})",
                            help.empty()                       ? ""
                            : format == kPictureFormats.back() ? " or "
                                                               : ", ",
                            format->ending, format->help);
    return help;
}

// What files have in them.
void add_file_options(Command& command, CaptureOptions& options) {
    number_option(command, "--quality", options.quality, 1, 100,
                  fmt::format("Quality of a .jpg: lower means smaller files (default {})", kJpegQuality));
    command
        .add_option(
            "--bits", &options.bits,
            "Bits of each colour of a .png: 8 (the default) or 16; of a film: 8 (the default) or 10; a .tif has 16")
        .one_of({"8", "10", "16"});
    command.add_flag(
        "--plain", &options.plain,
        fmt::format(
            "No dividing line, labels, scale bar, ticks or streamlines over a displayed picture or film ({} have none)",
            format_endings(" and ", [](const PictureFormat& f) { return f.sample == Sample::kLight; })));
    command.add_flag("--quiet", &options.quiet,
                     "No notes on standard error: unused parts of images, hints on smoother pictures");
    command.add_flag(
        "--half", &options.half,
        "Write an EXR's colours as half floats: half the size, three digits, at most 65504; without --raydata and "
        "--split");
    text_option(command, "--colour", options.colour,
                "Colours of an EXR: rec709, linear light; acescg, the same in ACEScg's primaries; display, what a .png "
                "shows (exposure, tone curve, bloom, labels) before its sRGB encoding, for films by ffmpeg",
                {"rec709", "acescg", "display"});
    command.add_flag("--raydata", &options.raydata,
                     "Also write where each pixel's ray ends, as channels of the EXR (docs/ray-data.md)");
    command
        .add_option("--derivatives", &options.derivatives,
                    "With --raydata: how the ray data, and places in the picture, change with these keys "
                    "(spin,camera.theta), as channels d_KEY.x ... of "
                    "the EXR; half a core-millisecond a pixel (docs/ray-data.md)")
        .needs("--raydata");
    command.add_flag("--layers", &options.layers,
                     "Write layers for compositing as channels of the EXR: image orders of the disc, bodies, sky, "
                     "coverage, ray data, ST maps, in sequences motion vectors (docs/layers.md)");
    command
        .add_option(
            "--st-map", &options.st_map,
            "Instead of colours write where each pixel looks: on a panorama of the sky, or on a flat plate that the "
            "same camera would see if light travelled straight (docs/layers.md)")
        .one_of({"sky", "plate"});
}

}  // namespace

bool CaptureOptions::format_has(std::string_view option) const {
    if (format() == nullptr) return to_film() && option == "--bits";
    const auto names = nullscope::split(format()->options, ' ');
    return std::ranges::find(names, option) != names.end();
}

bool CaptureOptions::to_one_picture() const { return frames.empty() && !to_film() && !names_frames(output); }

Status check_output(const CaptureOptions& options) {
    const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
    if (std::error_code none;
        !folder.empty() && !names_frames(folder.string()) && !std::filesystem::is_directory(folder, none))
        return failed(fmt::format("-o {}: there is no folder '{}'", options.output, folder.string()));
    if (options.format() == nullptr && !options.to_film())
        return bad_input(fmt::format("-o {}: unknown kind of file", options.output),
                         fmt::format("names that end in {} or {}", format_endings(", "), film_endings()));
    return Done{};
}

void add_capture_options(Command& command, CaptureOptions& options) {
    const KeyRange times = key_range("time");
    required_option(
        command, "scene", options.scene,
        "Scene file, the name of a built-in scene (see: nullscope scenes), or a picture that nullscope drew: "
        "its scene and options, where others are not given");
    text_option(command, "-o,--output", options.output,
                fmt::format("File to write, {}, or a film: {}, which needs ffmpeg and resumes "
                            "an interrupted run "
                            "of the same scene and options; NAME-%s.png writes the six faces of a cube",
                            format_endings(), film_endings()));
    command.add_option("ffmpeg", &options.ffmpeg, "After --: options of ffmpeg for a film, as in -- -crf 12");
    set_option(command, options.set);
    command.add_option("--size", &options.size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    command.add_option(
        "--split,--beside", &options.split,
        "Split screen: the right half shows this scene with the camera of the first; each half is centred");
    context_option(command, options.context);
    renderer_option(command, options.renderer);
    text_option(command, "--method", options.method,
                "How the shader traces rays: auto (see --max-error), strip, table[:SIZE[:LOOKUP]], closed-form, "
                "integrate[:ORDER[:STEP]], euler:STEPS; for a rotating hole mino[:ORDER[:STEP]], for its sky alone "
                "also mino:4 and kerr-schild:STEP");
    number_option(
        command, "--max-error", options.max_error, 1e-12, 1e6,
        fmt::format("For --method auto: use the fastest method whose measured error is below this many pixels "
                    "(default {}; where pixels are too small to guarantee that, the most accurate method)",
                    kDefaultMaxError_px));
    number_option(command, "--time", options.time, times.low, times.high,
                  "Scene time in r_s/c (default: the scene's); matters only if something in the scene moves");
    number_option(command, "--time-step", options.time_step, -1e6, 1e6,
                  "Scene time between two frames of --frames and films, r_s/c; not for a falling camera, whose path "
                  "sets the time");
    number_option(command, "--time-frame", options.time_frame, 0, 1e8,
                  "Frame at which time is the scene's, for a scene without a [path] (default: the first of --frames)")
        .needs("--frames");
    command.add_option("--frames", &options.frames,
                       "A:B draws frames A to B-1 of the scene's [path], or in steps of --time-step; -o then needs a "
                       "placeholder for the frame number (%05d, %d or #####) or is a film");
    number_option(command, "--workers", options.workers, 1, 64,
                  "Processes that draw the frames of a sequence or film together");
    command.add_flag(
        "--resume", &options.resume,
        "Skip frames whose files exist: resumes an interrupted sequence of the same scene and options; several "
        "runs may draw it at once (see: nullscope frames --help)");
    number_option(
        command, "--samples", options.samples, 1, 16,
        fmt::format("N x N rays per pixel (default: the scene's picture.samples; with --renderer reference {})",
                    kSamples));
    number_option(command, "--largest-texture", options.largest_texture, 16, 65536,
                  "Largest texture side in pixels: larger images are reduced while they are read (default: the "
                  "driver's limit)");
    add_file_options(command, options);
    text_option(command, "--tiles", options.tiles,
                "How the shader draws a disc: traced, only in tiles that show it (faster, equal up to rounding); "
                "bodies, in the whole picture; auto: traced for films and large pictures",
                {"auto", "bodies", "traced"});
    stage_option(command, options.stage);
    command.add_flag("--dump-shader", &options.dump_shader, "Print the shaders of this scene's passes and stop");
}

void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it) {
    static const std::string help = "Draw a scene to " + format_help();
    auto [command, options] = add_command<CaptureOptions>(parent, "capture", help.c_str(), run_it);
    command.note_given(&options.given);
    add_capture_options(command, options);
}

}  // namespace nullscope::cli
