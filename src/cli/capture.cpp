// nullscope capture: a picture of a scene in a file.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/atomic_file.h"
#include "base/assets.h"
#include "base/image_file.h"
#include "base/progress.h"
#include "cli/command.h"
#include "cli/session.h"
#include "compare/ray_channels.h"
#include "reference/reference.h"
#include "render/display.h"
#include "scene/scene_file.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string scene, output = "frame.png", size, context = "auto", renderer = "gl";
    int samples = 3;
    bool raydata = false, dump_shader = false;
};

struct Captured {
    Image<float> linear;                 // for .exr
    Image<unsigned char> display;        // for .png
    std::optional<RayFrame> rays;
    std::string made_by;
};

Result<Captured> capture_gl(const Scene& scene, const Options& options, bool exr) {
    auto session = open_session(options.context);
    if (!session) return session.error();
    if (Status ready = session->renderer->prepare(scene); !ready) return ready.error();
    Captured captured;
    if (exr) captured.linear = session->renderer->picture();
    else captured.display = session->renderer->picture8();
    if (options.raydata) captured.rays = session->renderer->ray_data();
    captured.made_by = session->context->kind() + ", " + session->renderer->info().renderer;
    return captured;
}

Result<Captured> capture_reference(const Scene& scene, const Options& options, bool exr) {
    constexpr int kSkyFace = 2048;
    auto sky = build_sky(scene.sky, assets_directory(), kSkyFace);
    if (!sky) return sky.error();
    std::optional<Image<float>> disc;
    if (scene.disc) {
        auto image = load_disc_image(*scene.disc);
        if (!image) return image.error();
        disc = std::move(*image);
    }
    const long long pixels = static_cast<long long>(scene.camera.width) * scene.camera.height;
    Captured captured;
    {
        Progress progress("reference picture", pixels);
        auto image = reference::render_frame(scene, *sky, disc ? &*disc : nullptr, options.samples,
                                             [&](long long n) { progress.advance(n); });
        if (!image) return image.error();
        captured.linear = std::move(*image);
    }
    if (options.raydata) {
        Progress progress("reference ray data", pixels);
        auto rays = reference::trace_frame(scene, [&](long long n) { progress.advance(n); });
        if (!rays) return rays.error();
        captured.rays = std::move(*rays);
    }
    if (!exr) captured.display = display_encoded(captured.linear, scene.camera.exposure_ev);
    captured.made_by = "reference tracer";
    return captured;
}

Status write(const Options& options, const Scene& scene, const Captured& captured, bool exr) {
    if (!exr) return save_png(options.output, captured.display);
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
    return save_exr(options.output, file);
}

int run(const Options& options) {
    auto scene = load_scene(options.scene);
    if (!scene) return report(scene.error());
    if (!options.size.empty()) {
        auto size = parse_size(options.size);
        if (!size) return report(size.error());
        scene->camera.width = size->width;
        scene->camera.height = size->height;
    }
    if (options.dump_shader) {
        const EffectSet effects = effect_set(required_effects(*scene));
        fmt::print("{}", shader_source(Stage::kPicture, effects, Output::kDisplay).fragment);
        return 0;
    }
    const bool exr = options.output.ends_with(".exr");
    if (!exr && !options.output.ends_with(".png"))
        return report(bad_input(fmt::format("-o {}: unknown kind of file; allowed: names that end in .png or .exr", options.output)));
    if (options.raydata && !exr) return report(bad_input("--raydata goes into an .exr; give -o FILE.exr"));
    const auto captured = options.renderer == "gl" ? capture_gl(*scene, options, exr) : capture_reference(*scene, options, exr);
    if (!captured) return report(captured.error());
    if (Status written = write(options, *scene, *captured, exr); !written) return report(written.error());
    fmt::print("{}: {}x{}, {}\n", options.output, scene->camera.width, scene->camera.height, captured->made_by);
    return 0;
}

}  // namespace

Command add_capture(CLI::App& parent) {
    auto options = std::make_shared<Options>();
    CLI::App* app = parent.add_subcommand("capture", "Draw a scene to a PNG (display-ready) or an EXR (linear light, optional ray data)");
    app->add_option("scene", options->scene, "Scene file, or the name of one that ships (see: nullscope scenes)")->required();
    app->add_option("-o,--output", options->output, "File to write, .png or .exr")->capture_default_str();
    app->add_option("--size", options->size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    app->add_option("--context", options->context, "OpenGL context: auto, egl, osmesa")
        ->check(CLI::IsMember({"auto", "egl", "osmesa"}))->capture_default_str();
    app->add_option("--renderer", options->renderer, "gl: the shader; reference: the double-precision tracer, slow")
        ->check(CLI::IsMember({"gl", "reference"}))->capture_default_str();
    app->add_option("--samples", options->samples, "reference: rays per pixel along each side")->check(CLI::Range(1, 16))->capture_default_str();
    app->add_flag("--raydata", options->raydata, "Also write where every pixel's ray went, as channels of the EXR");
    app->add_flag("--dump-shader", options->dump_shader, "Print the fragment shader of this scene and stop");
    return {app, [options] { return run(*options); }};
}

}  // namespace nullscope::cli
