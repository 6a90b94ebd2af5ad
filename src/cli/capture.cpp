// nullscope capture: a picture of a scene in a file.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/atomic_file.h"
#include "base/assets.h"
#include "base/image_file.h"
#include "base/large_image.h"
#include "base/progress.h"
#include "cli/arguments.h"
#include "camera/path.h"
#include "cli/command.h"
#include "cli/film.h"
#include "cli/session.h"
#include "compare/ray_channels.h"
#include "reference/reference.h"
#include "render/display.h"
#include "render/frontier.h"
#include "scene/scene_file.h"
#include "scene/split.h"
#include "shaderlib/passes.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string scene, beside, output = "frame.png", size, context = "auto", renderer = "gl", method = "auto", frames;
    int samples = 3;
    std::optional<double> time;
    double time_step = 0;
    std::optional<double> max_error;
    std::optional<int> largest_texture;
    bool raydata = false, dump_shader = false, resume = false;
};

struct Captured {
    Image<float> linear;                 // for .exr
    Image<unsigned char> display;        // for .png
    std::optional<RayFrame> rays;
    std::string made_by;
};

Result<Captured> capture_gl(Session& session, const Scene& scene, const Options& options, bool exr) {
    session.renderer->want_delays(options.raydata);
    if (options.largest_texture) session.renderer->limit_pictures(*options.largest_texture);
    if (Status ready = session.renderer->prepare(scene); !ready) return ready.error();
    for (const std::string& note : session.renderer->take_notes()) fmt::print(stderr, "{}\n", note);
    Captured captured;
    if (exr) captured.linear = session.renderer->picture();
    else captured.display = session.renderer->picture8();
    if (options.raydata) captured.rays = session.renderer->ray_data();
    captured.made_by = session.context->kind() + ", " + session.renderer->info().renderer;
    return captured;
}

Result<Captured> capture_reference(const Scene& scene, const Options& options, bool exr) {
    constexpr int kSkyFace = 2048;
    auto sky = build_sky(scene.sky, assets_directory(), kSkyFace);
    if (!sky) return sky.error();
    std::optional<SkyCube> far_sky;
    if (effect_set(required_effects(scene)).contains(Effect::kFarSky)) {
        auto built = build_sky(scene.far_sky, assets_directory(), kSkyFace);
        if (!built) return built.error();
        far_sky = std::move(*built);
    }
    std::optional<Image<float>> disc;
    if (effect_set(required_effects(scene)).contains(Effect::kDiscImage)) {
        auto image = load_disc_image(*scene.disc);
        if (!image) return image.error();
        disc = std::move(image->image);
    }
    std::array<std::optional<Image<float>>, kBodyCount> bodies;
    for (int body = 0; body < kBodyCount; ++body) {
        const auto file = body_image_file(scene, body);
        if (!file) continue;
        auto image = load_fitted_image(*file);
        if (!image) return image.error();
        bodies[static_cast<std::size_t>(body)] = std::move(image->image);
    }
    reference::Pictures pictures(disc ? &*disc : nullptr);
    if (bodies[0]) pictures.sphere = &*bodies[0];
    if (bodies[1]) pictures.cylinder = &*bodies[1];
    if (bodies[2]) pictures.ball = &*bodies[2];
    if (bodies[3]) pictures.surface = &*bodies[3];
    const auto stars = point_stars(scene.sky, assets_directory());
    if (!stars) return stars.error();
    const long long pixels = static_cast<long long>(scene.camera.width) * scene.camera.height;
    Captured captured;
    {
        Progress progress("reference picture", pixels);
        auto image = reference::render_frame(scene, *sky, pictures, options.samples,
                                             [&](long long n) { progress.advance(n); }, far_sky ? &*far_sky : nullptr, *stars);
        if (!image) return image.error();
        captured.linear = std::move(*image);
    }
    if (options.raydata) {
        Progress progress("reference ray data", pixels);
        auto rays = reference::trace_frame(scene, [&](long long n) { progress.advance(n); });
        if (!rays) return rays.error();
        captured.rays = std::move(*rays);
    }
    if (!exr) captured.display = display_encoded(captured.linear, scene.camera.exposure_ev, scene.picture);
    captured.made_by = "reference tracer";
    return captured;
}

Status write(const std::string& file_name, const Scene& scene, const Captured& captured, bool exr) {
    if (!exr) return save_png(file_name, captured.display);
    ChannelImage file;
    file.width = captured.linear.width;
    file.height = captured.linear.height;
    const char* names[3] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        auto& channel = file.channels[names[c]];
        channel.resize(static_cast<std::size_t>(file.width) * file.height);
        for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = captured.linear.data[3 * i + static_cast<std::size_t>(c)];
    }
    if (captured.rays) add_ray_channels(*captured.rays, file);
    file.attributes = {{"nullscope.scene", scene.name}, {"nullscope.renderer", captured.made_by}, {"nullscope.version", NULLSCOPE_VERSION}};
    return save_exr(file_name, file);
}

// auto: the cheapest that was measured to keep --max-error; said on standard error.
Result<Method> chosen_method(const Options& options, const Scene& scene) {
    if (options.method != "auto") {
        auto method = parse_method(options.method);
        // The renderer takes the default for auto.
        if (method && *method == Method{} && effect_set(required_effects(scene)).contains(Effect::kSpin))
            return bad_input("method strip is not there for a spinning hole; allowed: auto, mino[:ORDER[:STEP]], kerr-schild:STEP");
        return method;
    }
    const auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (!measured) return measured.error();
    const auto choice = options.max_error ? choose_method(*measured, scene, *options.max_error) : default_method(*measured, scene);
    if (!choice) return choice.error();
    if (options.max_error || choice->error_px > kDefaultMaxError_px) fmt::print(stderr, "method {}\n", choice->reason);
    return choice->method;
}

bool is_film(const Options& options) { return options.output.ends_with(".mp4"); }

Result<Frames> frames_of(const Options& options, const CameraPath* path) {
    if (is_film(options) && path == nullptr && (options.time_step == 0 || options.frames.empty()))
        return bad_input("a film needs a scene with a [path], or --time-step and --frames; allowed: -o names that end in .png or .exr");
    if (is_film(options) && !have_ffmpeg()) return failed("ffmpeg is not installed, it makes the film; without it: -o NAME%05d.png and --frames");
    if (options.frames.empty()) return is_film(options) ? Frames{0, path->frames()} : Frames{};
    const auto frames = parse_frames(options.frames);
    if (frames && path != nullptr && frames->end > path->frames())
        return bad_input(fmt::format("--frames {}: the path has {} frames; allowed: 0:{}", options.frames, path->frames(), path->frames()));
    if (frames && !is_film(options) && options.output.find("%05d") == std::string::npos)
        return bad_input(fmt::format("-o {}: a sequence needs a place for the frame's number; allowed: names that hold %05d", options.output));
    return frames;
}

std::string numbered(std::string name, int frame) {
    const std::size_t at = name.find("%05d");
    return at == std::string::npos ? name : name.replace(at, 4, fmt::format("{:05d}", frame));
}

Result<Scene> scene_for(const Options& options) {
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
Result<std::optional<Halves>> split_of(const Options& options, const Scene& scene) {
    if (options.beside.empty() && !scene.beside) return std::optional<Halves>();
    if (options.raydata) return bad_input("--raydata is of one spacetime; leave out --beside, or [beside] of the scene");
    if (options.beside.empty()) return halves(scene);
    auto other = load_scene(options.beside);
    if (!other) return other.error();
    return std::optional(halves(scene, *other));
}

Status check_output(const Options& options, bool exr) {
    if (!exr && !is_film(options) && !options.output.ends_with(".png"))
        return bad_input(fmt::format("-o {}: unknown kind of file; allowed: names that end in .png, .exr or .mp4", options.output));
    if (options.raydata && !exr) return bad_input("--raydata goes into an .exr; give -o FILE.exr");
    return Done{};
}

int run(const Options& options) {
    const auto scene = scene_for(options);
    if (!scene) return report(scene.error());
    std::optional<CameraPath> path;
    if (scene->path) {
        auto made = CameraPath::make(*scene);
        if (!made) return report(made.error());
        path = std::move(*made);
    }
    if (options.dump_shader) {
        const EffectSet effects = effect_set(required_effects(*scene));
        for (const Pass& pass : passes(effects, Output::kDisplay))
            fmt::print("{}", pass_text(pass, effects, {}, scene->spacetime.metric, body_text(*scene)));
        return 0;
    }
    if (const auto split = split_of(options, *scene); !split) return report(split.error());
    const bool exr = options.output.ends_with(".exr");
    if (Status good = check_output(options, exr); !good) return report(good.error());
    if (path && path->falls() && options.time_step != 0)
        return report(bad_input("--time-step: the scene's time goes with the camera that falls; allowed: scenes whose path.kind is not fall"));
    const auto frames = frames_of(options, path ? &*path : nullptr);
    if (!frames) return report(frames.error());
    std::optional<Session> session;
    if (options.renderer == "gl") {
        auto opened = open_session(options.context);
        if (!opened) return report(opened.error());
        session = std::move(*opened);
        const auto method = chosen_method(options, *scene);
        if (!method) return report(method.error());
        session->renderer->set_method(*method);
    }
    // A film's pictures wait in a folder beside it: a run that was stopped goes on from them.
    const std::string folder = options.output + ".frames";
    if (is_film(options)) {
        std::error_code error;
        if (std::filesystem::create_directories(folder, error); error) return report(failed(fmt::format("{}: {}", folder, error.message())));
    }
    std::optional<Progress> progress;
    if (frames->end - frames->first > 1) progress.emplace("frames", frames->end - frames->first);
    for (int frame = frames->first; frame < frames->end; ++frame) {
        const std::string file = numbered(is_film(options) ? folder + "/%05d.png" : options.output, frame);
        if ((options.resume || is_film(options)) && std::filesystem::exists(file)) {   // a file has its name only when it is whole
            if (progress) progress->advance();
            continue;
        }
        Scene now = *scene;
        now.time += (frame - (path ? 0 : frames->first)) * options.time_step;
        if (path) {
            now.camera = path->at(frame);
            now.time += path->clock(frame);
            now.camera.width = scene->camera.width, now.camera.height = scene->camera.height;
        }
        const auto capture = [&](const Scene& drawn) {
            return session ? capture_gl(*session, drawn, options, exr) : capture_reference(drawn, options, exr);
        };
        const auto split = split_of(options, now);
        if (!split) return report(split.error());
        auto captured = capture(*split ? (*split)->left : now);
        if (!captured) return report(captured.error());
        if (*split) {
            const auto right = capture((*split)->right);
            if (!right) return report(right.error());
            if (exr) captured->linear = side_by_side(captured->linear, right->linear);
            else captured->display = side_by_side(captured->display, right->display);
        }
        if (Status written = write(file, *scene, *captured, exr); !written) return report(written.error());
        if (progress) progress->advance();
        if (!is_film(options)) fmt::print("{}: {}x{}, {}\n", file, scene->camera.width, scene->camera.height, captured->made_by);
    }
    if (!is_film(options)) return 0;
    progress.reset();
    const double rate = scene->path ? scene->path->rate : PathSpec{}.rate;
    if (Status made = encode_film(folder, frames->first, rate, options.output); !made) return report(made.error());
    std::error_code error;
    std::filesystem::remove_all(folder, error);
    fmt::print("{}: {}x{}, {} frames at {} a second\n", options.output, scene->camera.width, scene->camera.height, frames->end - frames->first, rate);
    return 0;
}

}  // namespace

void add_capture(Command& parent) {
    auto options = std::make_shared<Options>();
    Command& command = parent.add_command(
        "capture", "Draw a scene to a PNG (display-ready) or an EXR (linear light, optional ray data)");
    command.add_option("scene", &options->scene, "Scene file, or the name of one that ships (see: nullscope scenes)")
        .required();
    command
        .add_option("-o,--output", &options->output,
                    "File to write, .png or .exr; of a scene with a [path] also .mp4, by ffmpeg where that is "
                    "installed (goes on with what a stopped run has drawn)")
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
                    "integrate[:ORDER[:STEP]], euler:STEPS; of a spinning hole mino[:ORDER[:STEP]], of its sky alone "
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
        .in_range(0.0, 1e9);
    command
        .add_option("--time-step", &options->time_step,
                    "Scene time from one frame to the next, r_s/c, of --frames and films, but of a camera that falls, "
                    "which has a clock: content moves, as light's delay shows it")
        .in_range(-1e6, 1e6)
        .show_default();
    command.add_option("--frames", &options->frames,
                       "Draw frames A to B-1 of the scene's [path], or as many with --time-step, A:B; -o then holds "
                       "%05d, or ends in .mp4");
    command.add_flag("--resume", &options->resume,
                     "Leave out the frames whose files are there: goes on with a sequence that was stopped");
    command.add_option("--samples", &options->samples, "reference: rays per pixel along each side")
        .in_range(1, 16)
        .show_default();
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
