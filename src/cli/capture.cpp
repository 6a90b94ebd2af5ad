// nullscope capture: a picture of a scene in a file.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "base/assets.h"
#include "base/progress.h"
#include "camera/path.h"
#include "cli/arguments.h"
#include "cli/capture_picture.h"
#include "cli/command.h"
#include "cli/film.h"
#include "cli/frame_names.h"
#include "cli/frame_stamp.h"
#include "cli/frame_store.h"
#include "render/frontier.h"
#include "scene/scene_file.h"
#include "scene/scene_keys.h"
#include "scene/split.h"
#include "shaderlib/passes.h"

namespace nullscope::cli {
namespace {

// auto: the cheapest that was measured to keep --max-error; said on standard error.
Result<Method> chosen_method(const CaptureOptions& options, const Scene& scene) {
    if (options.method != "auto") {
        auto method = parse_method(options.method);
        // The renderer takes the default for auto.
        if (method && *method == Method{} &&
            light_path_kind(effect_set(required_effects(scene))) == LightPathKind::kMino)
            return bad_input(
                "method strip is not there for a rotating hole; allowed: auto, mino[:ORDER[:STEP]], kerr-schild:STEP");
        return method;
    }
    const auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (!measured) return measured.error();
    const auto choice =
        options.max_error ? choose_method(*measured, scene, *options.max_error) : default_method(*measured, scene);
    if (!choice) return choice.error();
    if (options.max_error || choice->error_px > kDefaultMaxError_px) fmt::print(stderr, "method {}\n", choice->reason);
    return choice->method;
}

bool is_film(const CaptureOptions& options) { return options.output.ends_with(".mp4"); }
std::string film_folder(const CaptureOptions& options) { return options.output + ".frames"; }

Result<Frames> frames_of(const CaptureOptions& options, const CameraPath* path) {
    if (is_film(options) && path == nullptr && (options.time_step == 0 || options.frames.empty()))
        return bad_input(
            "a film needs a scene with a [path], or --time-step and --frames; allowed: -o names that end in .png or "
            ".exr");
    if (is_film(options) && !have_ffmpeg())
        return failed("ffmpeg is not installed, it makes the film; without it: -o NAME%05d.png and --frames");
    if (options.frames.empty()) return is_film(options) ? Frames{0, path->frames()} : Frames{};
    auto frames = parse_frames(options.frames);
    if (frames && path != nullptr && frames->end > path->frames())
        return bad_input(fmt::format("--frames {}: the path has {} frames; allowed: 0:{}", options.frames,
                                     path->frames(), path->frames()));
    return frames;
}

// Of a sequence's files. Nothing: one picture, or a film, whose pictures have a folder of their own.
Result<std::optional<FrameNames>> names_of(const CaptureOptions& options) {
    if (is_film(options) || options.frames.empty()) return std::optional<FrameNames>();
    auto names = FrameNames::parse(options.output);
    if (!names) return names.error();
    return std::optional(std::move(*names));
}

Result<Scene> scene_for(const CaptureOptions& options) {
    auto scene = load_scene(options.scene);
    if (scene && options.time) scene->time = *options.time;
    if (!scene || options.size.empty()) return scene;
    const auto size = parse_size(options.size);
    if (!size) return size.error();
    scene->camera.width = size->width;
    scene->camera.height = size->height;
    return scene;
}

// Nothing where the picture is one scene's.
Result<std::optional<Halves>> split_of(const CaptureOptions& options, const Scene& scene) {
    if (options.beside.empty() && !scene.beside) return std::optional<Halves>();
    if (options.raydata)
        return bad_input("--raydata is of one spacetime; leave out --beside, or [beside] of the scene");
    if (options.beside.empty()) return halves(scene);
    auto other = load_scene(options.beside);
    if (!other) return other.error();
    return std::optional(halves(scene, *other));
}

// Files of an unknown kind, and options that would change nothing.
Status check_options(const CaptureOptions& options, bool exr) {
    if (!exr && !is_film(options) && !options.output.ends_with(".png"))
        return bad_input(
            fmt::format("-o {}: unknown kind of file; allowed: names that end in .png, .exr or .mp4", options.output));
    if (options.raydata && !exr) return bad_input("--raydata goes into an .exr; give -o FILE.exr");
    if (options.samples && options.renderer != "reference")
        return bad_input("--samples: the shader takes one ray a pixel; allowed: with --renderer reference");
    if (options.renderer == "reference")
        for (const auto& [option, given] : {std::pair{"--method", options.method != "auto"},
                                            {"--max-error", options.max_error.has_value()},
                                            {"--context", options.context != CaptureOptions{}.context},
                                            {"--largest-texture", options.largest_texture.has_value()}})
            if (given)
                return bad_input(
                    fmt::format("{}: the reference has no shader and no GL; allowed: with --renderer gl", option));
    return Done{};
}

int dump_shader(const Scene& scene) {
    const EffectSet effects = effect_set(required_effects(scene));
    for (const Pass& pass : passes(effects, Output::kDisplay))
        fmt::print("{}", pass_text(pass, effects, {}, scene.spacetime.metric, body_text(scene, effects)));
    return 0;
}

// What is to be drawn, checked.
struct Job {
    Scene scene;
    std::optional<CameraPath> path;
    Frames frames;
    std::optional<FrameNames> names;  // of a sequence
    Method method;                    // of the shader
    bool exr = false;
};

// The scene of a frame. Without a path the first frame that is drawn has the scene's time.
Scene scene_at(const Job& job, double time_step, int frame) {
    Scene now = job.scene;
    now.time += (frame - (job.path ? 0 : job.frames.first)) * time_step;
    if (!job.path) return now;
    now.camera = job.path->at(frame);
    now.time += job.path->clock(frame);
    now.camera.width = job.scene.camera.width, now.camera.height = job.scene.camera.height;
    return now;
}

// One picture, or two side by side, into a file. Returns what it was made by.
Result<std::string> draw(Session* session, const Scene& scene, const CaptureOptions& options, bool exr,
                         const std::string& file) {
    const auto split = split_of(options, scene);
    if (!split) return split.error();
    auto captured = capture_picture(session, *split ? (*split)->left : scene, options, exr);
    if (!captured) return captured.error();
    if (*split) {
        const auto right = capture_picture(session, (*split)->right, options, exr);
        if (!right) return right.error();
        if (exr)
            captured->linear = side_by_side(captured->linear, right->linear);
        else
            captured->display = side_by_side(captured->display, right->display);
    }
    if (Status written = write_picture(file, scene, *captured, exr); !written) return written.error();
    return captured->made_by;
}

Result<Job> job_of(const CaptureOptions& options, Scene scene) {
    Job job{std::move(scene), {}, {}, {}, {}, options.output.ends_with(".exr")};
    if (job.scene.path) {
        auto made = CameraPath::make(job.scene);
        if (!made) return made.error();
        job.path = std::move(*made);
    }
    if (const auto split = split_of(options, job.scene); !split) return split.error();
    if (Status good = check_options(options, job.exr); !good) return good.error();
    if (job.path && job.path->falls() && options.time_step != 0)
        return bad_input(
            "--time-step: the scene's time goes with the camera that falls; allowed: scenes whose path.kind is not "
            "fall");
    const auto frames = frames_of(options, job.path ? &*job.path : nullptr);
    if (!frames) return frames.error();
    job.frames = *frames;
    auto names = names_of(options);
    if (!names) return names.error();
    job.names = std::move(*names);
    if (options.renderer != "gl") return job;
    const auto method = chosen_method(options, job.scene);
    if (!method) return method.error();
    job.method = *method;
    return job;
}

// Where the pictures of a film or a sequence go, and which of them are there. Nothing: one picture.
Result<std::unique_ptr<FrameStore>> store_of(const Job& job, const CaptureOptions& options) {
    if (!is_film(options) && !job.names) return std::unique_ptr<FrameStore>();
    std::optional<Scene> beside;
    if (!options.beside.empty()) {
        auto other = load_scene(options.beside);
        if (!other) return other.error();
        beside = std::move(*other);
    }
    const double first_time = job.scene.time - (job.path ? 0 : job.frames.first) * options.time_step;
    const std::string stamp = frame_stamp(
        {job.scene, beside ? &*beside : nullptr, options, method_name(job.method), first_time, NULLSCOPE_VERSION});
    auto store = is_film(options) ? FrameStore::open_film(film_folder(options), stamp)
                                  : FrameStore::open_sequence(*job.names, job.frames, stamp, options.resume);
    if (!store) return store.error();
    return std::make_unique<FrameStore>(std::move(*store));
}

// Those that the store has not.
Status draw_frames(const Job& job, Session* session, const CaptureOptions& options, FrameStore* store) {
    const int count = job.frames.end - job.frames.first;
    std::optional<Progress> progress;
    if (count > 1) progress.emplace("frames", count);
    for (int frame = job.frames.first; frame < job.frames.end; ++frame) {
        const std::string file = store != nullptr ? store->file(frame) : options.output;
        const bool there = store != nullptr && (options.resume || is_film(options)) && store->has(frame);
        if (!there) {
            const auto made_by = draw(session, scene_at(job, options.time_step, frame), options, job.exr, file);
            if (!made_by) return made_by.error();
            if (store != nullptr) store->drew_one();
            if (!is_film(options))
                fmt::print("{}: {}x{}, {}\n", file, job.scene.camera.width, job.scene.camera.height, *made_by);
        }
        if (progress) progress->advance();
    }
    return Done{};
}

Status finish_film(const Job& job, const CaptureOptions& options) {
    const double rate = job.scene.path ? job.scene.path->rate : PathSpec{}.rate;
    const int count = job.frames.end - job.frames.first;
    if (Status made = encode_film(film_folder(options), job.frames.first, count, rate, options.output); !made)
        return made;
    std::error_code error;
    std::filesystem::remove_all(film_folder(options), error);
    fmt::print("{}: {}x{}, {} frames at {} a second\n", options.output, job.scene.camera.width, job.scene.camera.height,
               count, rate);
    return Done{};
}

int run(const CaptureOptions& options) {
    auto scene = scene_for(options);
    if (!scene) return report(scene.error());
    if (options.dump_shader) return dump_shader(*scene);
    const auto job = job_of(options, std::move(*scene));
    if (!job) return report(job.error());
    const auto store = store_of(*job, options);
    if (!store) return report(store.error());
    std::optional<Session> session;
    if (options.renderer == "gl") {
        auto opened = open_session(options.context);
        if (!opened) return report(opened.error());
        session = std::move(*opened);
        session->renderer->set_method(job->method);
    }
    if (Status drawn = draw_frames(*job, session ? &*session : nullptr, options, store->get()); !drawn)
        return report(drawn.error());
    if (!is_film(options)) return 0;
    if (Status made = finish_film(*job, options); !made) return report(made.error());
    return 0;
}

}  // namespace

void add_capture(Command& parent) {
    auto options = std::make_shared<CaptureOptions>();
    const KeyRange times = key_range("time");
    Command& command = parent.add_command(
        "capture", "Draw a scene to a PNG (display-ready) or an EXR (linear light, optional ray data)");
    command.add_option("scene", &options->scene, "Scene file, or the name of one that ships (see: nullscope scenes)")
        .required();
    command
        .add_option("-o,--output", &options->output,
                    "File to write, .png or .exr; of a scene with a [path] also .mp4, by ffmpeg where that is "
                    "installed (resumes an interrupted run of the same scene and options)")
        .show_default();
    command.add_option("--size", &options->size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    command.add_option(
        "--beside", &options->beside,
        "Split screen: the right half shows this scene, seen by the camera of the first; each half is centred");
    context_option(command, options->context);
    command.add_option("--renderer", &options->renderer, "gl: the shader; reference: the double-precision tracer, slow")
        .one_of({"gl", "reference"})
        .show_default();
    command
        .add_option("--method", &options->method,
                    "How the shader traces: auto (see --max-error), strip, table[:SIZE[:LOOKUP]], closed-form, "
                    "integrate[:ORDER[:STEP]], euler:STEPS; of a rotating hole mino[:ORDER[:STEP]], of its sky alone "
                    "also mino:4 and kerr-schild:STEP")
        .show_default();
    command
        .add_option(
            "--max-error", &options->max_error,
            fmt::format("auto: the cheapest method whose measured error stays under this many pixels "
                        "(default {}, and the most exact method where the pixels are too small to be sure of that)",
                        kDefaultMaxError_px))
        .in_range(1e-12, 1e6);
    command
        .add_option(
            "--time", &options->time,
            "Scene time in r_s/c (default: the scene's); scenes without anything that moves look the same at all times")
        .in_range(times.low, times.high);
    command
        .add_option("--time-step", &options->time_step,
                    "Scene time from one frame to the next, r_s/c, of --frames and films, but of a camera that falls, "
                    "which has a clock: content moves, as light's delay shows it")
        .in_range(-1e6, 1e6)
        .show_default();
    command.add_option("--frames", &options->frames,
                       "Draw frames A to B-1 of the scene's [path], or as many with --time-step, A:B; -o then holds "
                       "a place for the number, %05d, %d or #####, or ends in .mp4");
    command.add_flag(
        "--resume", &options->resume,
        "Leave out the frames whose files are there: resumes an interrupted sequence of the same scene and options");
    command
        .add_option("--samples", &options->samples,
                    fmt::format("reference: rays per pixel along each side (default {})", kSamples))
        .in_range(1, 16);
    command
        .add_option("--largest-texture", &options->largest_texture,
                    "Most pixels along a side of an image's texture: larger images are made "
                    "smaller while they are read (default: the driver's limit)")
        .in_range(16, 65536);
    command.add_flag("--raydata", &options->raydata, "Also write where every pixel's ray went, as channels of the EXR");
    command.add_flag("--dump-shader", &options->dump_shader, "Print the shaders of this scene's passes and stop");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
