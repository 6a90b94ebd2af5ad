#include "cli/capture_picture.h"

#include <fmt/format.h>

#include <array>

#include "base/assets.h"
#include "base/image_file.h"
#include "base/large_image.h"
#include "base/progress.h"
#include "compare/ray_channels.h"
#include "reference/reference.h"
#include "render/display.h"
#include "scene/effects.h"

namespace nullscope::cli {
namespace {

Result<Captured> capture_gl(Session& session, const Scene& scene, const CaptureOptions& options, bool exr) {
    session.renderer->want_delays(options.raydata);
    if (options.largest_texture) session.renderer->limit_pictures(*options.largest_texture);
    if (Status ready = session.renderer->prepare(scene); !ready) return ready.error();
    for (const std::string& note : session.renderer->take_notes()) fmt::print(stderr, "{}\n", note);
    Captured captured;
    if (exr)
        captured.linear = session.renderer->picture();
    else
        captured.display = session.renderer->picture8();
    if (options.raydata) captured.rays = session.renderer->ray_data();
    captured.made_by = session.context->kind() + ", " + session.renderer->info().renderer;
    return captured;
}

Result<Captured> capture_reference(const Scene& scene, const CaptureOptions& options, bool exr) {
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
        auto image = reference::render_frame(
            scene, *sky, pictures, options.samples.value_or(kSamples), [&](long long n) { progress.advance(n); },
            far_sky ? &*far_sky : nullptr, *stars);
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

}  // namespace

Result<Captured> capture_picture(Session* session, const Scene& scene, const CaptureOptions& options, bool exr) {
    return session != nullptr ? capture_gl(*session, scene, options, exr) : capture_reference(scene, options, exr);
}

Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured, bool exr) {
    if (!exr)
        return save_png(file_name, captured.display,
                        {{"Title", scene.name}, {"Software", "nullscope " NULLSCOPE_VERSION}});
    ChannelImage file;
    file.width = captured.linear.width;
    file.height = captured.linear.height;
    const char* names[3] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        auto& channel = file.channels[names[c]];
        channel.resize(static_cast<std::size_t>(file.width) * file.height);
        for (std::size_t i = 0; i < channel.size(); ++i)
            channel[i] = captured.linear.data[3 * i + static_cast<std::size_t>(c)];
    }
    if (captured.rays) add_ray_channels(*captured.rays, file);
    file.attributes = {{"nullscope.scene", scene.name},
                       {"nullscope.renderer", captured.made_by},
                       {"nullscope.version", NULLSCOPE_VERSION}};
    return save_exr(file_name, file);
}

}  // namespace nullscope::cli
