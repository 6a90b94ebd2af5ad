#include "cli/capture_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/frame_store.h"
#include "command/options.h"
#include "image/image_file.h"
#include "scenefile/scene_keys.h"
#include "shaderlib/frontier.h"

namespace nullscope::cli {

bool CaptureOptions::to_one_picture() const { return frames.empty() && !to_film() && !names_frames(output); }

Status check_options(const CaptureOptions& options) {
    const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
    if (std::error_code none; !folder.empty() && !names_frames(folder) && !std::filesystem::is_directory(folder, none))
        return failed(fmt::format("-o {}: there is no folder '{}'", options.output, folder.string()));
    if (!options.to_linear_light() && !options.to_film() && !options.to_jpeg() && !options.output.ends_with(".png"))
        return bad_input(fmt::format("-o {}: unknown kind of file", options.output),
                         fmt::format("names that end in .png, .jpg, .exr, .fits or {}", film_endings()));
    if (options.workers > 1 && options.to_one_picture())
        return bad_input("--workers: one picture is drawn by one process; give --frames A:B or a film");
    if (options.quality && !options.to_jpeg()) return bad_input("--quality is of a JPEG; give -o FILE.jpg");
    if (options.layers && (!options.to_exr() || !options.split.empty() || options.renderer != "gl"))
        return bad_input("--layers are of an .exr that the shader draws",
                         "-o FILE.exr, without --split and --renderer reference");
    if (!options.st_map.empty() && (!options.to_exr() || !options.split.empty() || options.raydata || options.layers))
        return bad_input("--st-map is what an .exr holds", "-o FILE.exr, without --split, --raydata and --layers");
    if (options.half && (!options.to_exr() || options.raydata || options.layers || !options.st_map.empty() ||
                         !options.split.empty() || options.renderer != "gl"))
        return bad_input("--half is of an .exr of colours that the shader draws",
                         "-o FILE.exr, without --raydata, --layers, --st-map, --split and --renderer reference");
    if (options.max_error && options.method != "auto")
        return bad_input(fmt::format("--max-error: --method {} is the one that was asked for", options.method),
                         "--method auto");
    if (options.resume && options.to_one_picture())
        return bad_input("--resume: one picture is drawn anew", "with --frames A:B, or -o NAME%05d.png");
    if (options.samples && !options.st_map.empty())
        return bad_input("--samples: an ST map has one ray a pixel", "without --st-map");
    if (options.raydata && !options.to_exr()) return bad_input("--raydata goes into an .exr; give -o FILE.exr");
    if (options.renderer == "reference")
        for (const auto& [option, given] : {std::pair{"--method", options.method != "auto"},
                                            {"--max-error", options.max_error.has_value()},
                                            {"--context", options.context != CaptureOptions{}.context},
                                            {"--tiles", options.tiles != "auto"},
                                            {"--largest-texture", options.largest_texture.has_value()}})
            if (given)
                return bad_input(fmt::format("{}: the reference has no shader and no GL", option),
                                 "with --renderer gl");
    return Done{};
}

void add_capture_options(Command& command, CaptureOptions& options) {
    const KeyRange times = key_range("time");
    required_option(
        command, "scene", options.scene,
        "Scene file, the name of a built-in scene (see: nullscope scenes), or a picture that nullscope drew: "
        "its scene and options, where others are not given");
    text_option(command, "-o,--output", options.output,
                fmt::format("File to write, .png, .jpg, .exr or .fits, or a film: {}, which needs ffmpeg and resumes "
                            "an interrupted run "
                            "of the same scene and options; NAME-%s.png writes the six faces of a cube",
                            film_endings()));
    command.add_option("ffmpeg", &options.ffmpeg, "After --: options of ffmpeg for a film, as in -- -crf 12");
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
                  "Frame that has the scene's time, for a scene without a [path] (default: the first of --frames)")
        .needs("--frames");
    command.add_option("--frames", &options.frames,
                       "A:B draws frames A to B-1 of the scene's [path], or in steps of --time-step; -o then needs a "
                       "place for the frame number (%05d, %d or #####) or is a film");
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
    number_option(command, "--quality", options.quality, 1, 100,
                  fmt::format("Quality of a .jpg: less makes smaller files (default {})", kJpegQuality));
    command.add_flag("--plain", &options.plain,
                     "No dividing line, labels or scale bar over a .png, .jpg or film (.exr and .fits have none)");
    command.add_flag("--quiet", &options.quiet,
                     "No notes on standard error: what of an image is not used, what would be smoother");
    command.add_flag(
        "--half", &options.half,
        "Write an EXR's colours as half floats: half the size, three digits, at most 65504; without --raydata and "
        "--split");
    command.add_flag("--raydata", &options.raydata,
                     "Also write where each pixel's ray ends, as channels of the EXR (docs/ray-data.md)");
    command.add_flag(
        "--layers", &options.layers,
        "Write what compositing needs as channels of the EXR: the disc's image orders, bodies and sky apart, what "
        "covers the sky, ray data, ST maps, in sequences motion vectors (docs/layers.md)");
    command
        .add_option(
            "--st-map", &options.st_map,
            "Instead of colours write where each pixel looks: on a panorama of the sky, or on a flat plate that the "
            "same camera would see if light ran straight (docs/layers.md)")
        .one_of({"sky", "plate"});
    text_option(
        command, "--tiles", options.tiles,
        "How the shader draws a disc: traced, in tiles that show some of it (faster, the same but for rounding); "
        "bodies, at once; auto: traced where there is much to draw",
        {"auto", "bodies", "traced"});
    command.add_flag("--dump-shader", &options.dump_shader, "Print the shaders of this scene's passes and stop");
}

void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it) {
    auto [command, options] = add_command<CaptureOptions>(parent, "capture",
                                                          "Draw a scene to a PNG or JPEG (display-ready), an EXR "
                                                          "(linear light, optional ray data) or a FITS (linear light, "
                                                          "sky coordinates)",
                                                          run_it);
    command.note_given(&options.given);
    add_capture_options(command, options);
}

}  // namespace nullscope::cli
