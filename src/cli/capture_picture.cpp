#include "cli/capture_picture.h"

#include <fmt/format.h>

#include "base/assets.h"
#include "base/progress.h"
#include "command/reference_inputs.h"
#include "compare/ray_channels.h"
#include "image/image_file.h"
#include "reference/reference.h"
#include "render/display.h"

namespace nullscope::cli {
namespace {

Result<Captured> capture_gl(Session& session, const Scene& scene, const CaptureOptions& options) {
    session.renderer->want_delays(options.raydata);
    if (options.largest_texture) session.renderer->limit_pictures(*options.largest_texture);
    TRY(ready, session.renderer->prepare(scene));
    for (const std::string& note : session.renderer->take_notes()) fmt::print(stderr, "{}\n", note);
    Captured captured;
    if (options.to_exr())
        captured.linear = session.renderer->picture();
    else
        captured.display = session.renderer->picture8();
    if (options.raydata) captured.rays = session.renderer->ray_data();
    captured.made_by = session.context->kind() + ", " + session.renderer->info().renderer;
    return captured;
}

Result<Captured> capture_reference(const Scene& scene, const CaptureOptions& options) {
    TRY(inputs, load_reference_inputs(scene));
    TRY(stars, point_stars(scene.sky, assets_directory()));
    const long long pixels = static_cast<long long>(scene.camera.width) * scene.camera.height;
    Captured captured;
    {
        Progress progress("reference picture", pixels);
        TRY(image, reference::render_frame(
                       scene, (*inputs)->sky, (*inputs)->pictures(scene), options.samples.value_or(kSamples),
                       [&](long long n) { progress.advance(n); }, (*inputs)->far(), *stars));
        captured.linear = std::move(*image);
    }
    if (options.raydata) {
        Progress progress("reference ray data", pixels);
        TRY(rays, reference::trace_frame(scene, [&](long long n) { progress.advance(n); }));
        captured.rays = std::move(*rays);
    }
    if (!options.to_exr()) captured.display = display_encoded(captured.linear, scene.camera.exposure_ev, scene.picture);
    captured.made_by = "reference tracer";
    return captured;
}

}  // namespace

Result<Captured> capture_picture(Session* session, const Scene& scene, const CaptureOptions& options) {
    return session != nullptr ? capture_gl(*session, scene, options) : capture_reference(scene, options);
}

Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured, int jpeg_quality) {
    if (file_name.ends_with(".jpg") || file_name.ends_with(".jpeg"))
        return save_jpeg(file_name, captured.display, scene.name + "\nnullscope " NULLSCOPE_VERSION, jpeg_quality);
    if (!file_name.ends_with(".exr"))
        return save_png(file_name, captured.display,
                        {{"Title", scene.name}, {"Software", "nullscope " NULLSCOPE_VERSION}});
    ChannelImage file{captured.linear.width, captured.linear.height, {}, {}};
    std::size_t place = 0;
    for (const char* name : {"R", "G", "B"}) {
        auto& channel = file.channels[name];
        for (std::size_t i = place++; i < captured.linear.data.size(); i += 3)
            channel.push_back(captured.linear.data[i]);
    }
    if (captured.rays) add_ray_channels(*captured.rays, file);
    file.attributes = {{"nullscope.scene", scene.name},
                       {"nullscope.renderer", captured.made_by},
                       {"nullscope.version", NULLSCOPE_VERSION}};
    return save_exr(file_name, file);
}

}  // namespace nullscope::cli
