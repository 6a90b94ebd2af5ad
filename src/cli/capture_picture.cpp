#include "cli/capture_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "base/progress.h"
#include "base/text.h"
#include "cli/capture_layers.h"
#include "cli/fits_header.h"
#include "cli/flux.h"
#include "command/reference_inputs.h"
#include "compare/ray_channels.h"
#include "image/channels.h"
#include "image/image_file.h"
#include "reference/reference.h"
#include "render/display.h"
#include "render/picture_bands.h"
#include "scenefile/scene_writer.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

void begin(Session& session, const CaptureOptions& options) {
    session.renderer->want_delays(options.raydata || options.layers);
    if (options.largest_texture) session.renderer->limit_pictures(*options.largest_texture);
}

std::string made_by(const Session& session) {
    return session.context->kind() + ", " + session.renderer->info().renderer;
}

void print_notes(Session& session) {
    for (const std::string& note : session.renderer->take_notes()) fmt::print(stderr, "{}\n", note);
}

// Of bands that draw(band) gives.
template <class T, class Draw>
Result<Image<T>> large_picture(Session& session, const CameraSpec& camera, Draw draw) {
    Image<T> picture(camera.width, camera.height, 3);
    Progress progress("large picture", camera.height);
    for (const PictureBand& band : picture_bands(camera)) {
        TRY(rows, draw(band));
        print_notes(session);
        std::ranges::copy(rows->data, picture.at(0, band.top));
        progress.advance(band.rows);
    }
    return picture;
}

// 8 bits a colour: a picture of 16384x16384 px is held.
Result<Image<unsigned char>> picture8(Session& session, const Exposure& shown) {
    if (!is_drawn_in_bands(shown.scene)) return draw_picture8(*session.renderer, shown);
    const CameraSpec& camera = shown.scene.camera;
    if (Status fits = check_size8(camera.width, camera.height); !fits) return fits.error();
    return large_picture<unsigned char>(
        session, camera, [&](const PictureBand& band) { return draw_band8(*session.renderer, shown, band); });
}

// EXR files of large pictures are written band by band (capture_large_exr).
Result<Image<float>> linear_picture(Session& session, const Exposure& shown, const CaptureOptions& options) {
    if (!options.to_fits() || !is_drawn_in_bands(shown.scene)) return draw_picture(*session.renderer, shown);
    return large_picture<float>(session, shown.scene.camera,
                                [&](const PictureBand& band) { return draw_band(*session.renderer, shown, band); });
}

Result<Captured> capture_gl(Session& session, const Exposure& shown, const CaptureOptions& options, const Scene* next) {
    begin(session, options);
    Captured captured;
    captured.made_by = made_by(session);
    if (options.layers) {
        TRY(layers, capture_layers(session, shown.scene, next));
        captured.linear = std::move(layers->layers.all);
        captured.layers = std::move(*layers);
    } else if (!options.st_map.empty()) {
        TRY(ready, session.renderer->prepare(shown.scene));
        captured.linear = st_map_of(session.renderer->ray_data(), shown.scene, options.st_map);
    } else if (options.to_linear_light()) {
        TRY(light, linear_picture(session, shown, options));
        captured.linear = std::move(*light);
    } else {
        TRY(picture, picture8(session, shown));
        captured.display = std::move(*picture);
    }
    print_notes(session);
    if (options.raydata) captured.rays = session.renderer->ray_data();
    return captured;
}

constexpr const char* kReference = "reference tracer";

Result<RayFrame> reference_rays(const Scene& scene) {
    Progress progress("reference ray data", static_cast<long long>(scene.camera.width) * scene.camera.height);
    return reference::trace_frame(scene, [&](long long n) { progress.advance(n); });
}

// What the reference has of a scene's files.
struct Inputs {
    std::unique_ptr<const ReferenceInputs> loaded;
    std::vector<PointStar> stars;
};

Result<Captured> capture_reference(const Inputs& inputs, const Exposure& shown, const CaptureOptions& options) {
    const Scene& scene = shown.scene;
    const long long pixels = static_cast<long long>(scene.camera.width) * scene.camera.height;
    Captured captured;
    {
        Progress progress("reference picture", pixels * std::max(std::ssize(shown.sub_frames), std::ptrdiff_t{1}));
        TRY(image, mean_light(shown, [&](const Scene& each) {
                return reference::render_frame(
                    each, inputs.loaded->sky, inputs.loaded->pictures(each), options.samples.value_or(kSamples),
                    [&](long long n) { progress.advance(n); }, inputs.loaded->far(), inputs.stars);
            }));
        captured.linear = std::move(*image);
    }
    if (options.raydata) {
        TRY(rays, reference_rays(scene));
        captured.rays = std::move(*rays);
    }
    if (!options.to_linear_light())
        captured.display = display_encoded(captured.linear, scene.camera.exposure_ev, scene.picture);
    captured.made_by = kReference;
    return captured;
}

// No picture of the sky is loaded for it.
Result<Captured> reference_st_map(const Scene& scene, const std::string& of) {
    TRY(rays, reference_rays(scene));
    Captured captured;
    captured.linear = st_map_of(*rays, scene, of);
    captured.made_by = kReference;
    return captured;
}

std::map<std::string, std::string> words_of(const Scene& scene, const std::string& made_by, std::optional<int> frame) {
    const std::string text = scene_file_text(scene, {});
    std::map<std::string, std::string> words = {{"nullscope.scene", scene.name},
                                                {"nullscope.scene_text", text},
                                                {"nullscope.scene_hash", fmt::format("{:016x}", fnv1a(text))},
                                                {"nullscope.renderer", made_by},
                                                {"nullscope.version", kVersionText}};
    if (frame) words["nullscope.frame"] = fmt::format("{}", *frame);
    return words;
}

bool is_several(const Scene& scene, const CaptureOptions& options) {
    return !options.split.empty() || scene.split || scene.camera.stereo != Stereo::kOff;
}

FitsHeader header_of(const Scene& scene, const Captured& captured, const CaptureOptions& options,
                     std::optional<int> frame) {
    const bool several = is_several(scene, options);
    FitsHeader header{.unit_comment = "relative luminance: linear light, 1 is white"};
    if (const auto flux = flux_unit(scene, several)) {
        header.unit = "Jy/pixel", header.unit_comment = "flux density of a pixel";
        header.cards.push_back({"FREQ", 1e9 * flux->frequency_GHz, "[Hz] as the camera sees it"});
    }
    add_coordinates(scene, several, header);
    add_scene(scene, header);
    for (const char* key : {"TELESCOP", "ORIGIN"}) header.cards.push_back({key, "nullscope", ""});
    header.cards.push_back({"CREATOR", fmt::format("nullscope {}", kVersionText), "program and version"});
    header.cards.push_back({"RENDERER", captured.made_by, ""});
    header.cards.push_back({"SCENE", scene.name, ""});
    header.cards.push_back(
        {"SCENHASH", words_of(scene, {}, {})["nullscope.scene_hash"], "FNV-1a of its canonical text"});
    if (frame) header.cards.push_back({"FRAME", static_cast<long long>(*frame), "of a sequence"});
    return header;
}

}  // namespace

Status check_size8(int width, int height) {
    constexpr long long kMostBytes = std::numeric_limits<int>::max();  // of the packages that write it
    if (3LL * width * height <= kMostBytes) return Done{};
    return bad_input(fmt::format("a picture of {}x{} px is too large for .png and .jpg", width, height),
                     fmt::format("{} million pixels, or -o FILE.exr", kMostBytes / 3'000'000));
}

Result<PictureDrawer> picture_drawer(Session* session, const Scene& scene, const CaptureOptions& options) {
    if (session != nullptr)
        return PictureDrawer(
            [session, options](const Exposure& shown) { return capture_gl(*session, shown, options, nullptr); });
    TRY(loaded, load_reference_inputs(scene));
    TRY(stars, point_stars(scene.sky, assets_directory()));
    const auto inputs = std::make_shared<const Inputs>(Inputs{std::move(*loaded), std::move(*stars)});
    return PictureDrawer(
        [inputs, options](const Exposure& shown) { return capture_reference(*inputs, shown, options); });
}

Result<Captured> capture_picture(Session* session, const Exposure& shown, const CaptureOptions& options,
                                 const Scene* next) {
    if (session != nullptr) return capture_gl(*session, shown, options, next);
    if (!options.st_map.empty()) return reference_st_map(shown.scene, options.st_map);
    TRY(draw, picture_drawer(nullptr, shown.scene, options));
    return (*draw)(shown);
}

Result<std::string> capture_large_exr(Session& session, const Scene& told, const std::vector<Exposure>& shown,
                                      const CaptureOptions& options, const std::string& file_name,
                                      std::optional<int> frame) {
    const CameraSpec& camera = shown.front().scene.camera;
    begin(session, options);
    const std::vector<PictureBand> bands = picture_bands(camera);
    Progress progress("large picture", camera.height);
    const BandedImage image{camera.width * static_cast<int>(shown.size()), camera.height, options.half,
                            words_of(told, made_by(session), frame)};
    TRY(saved, save_exr_bands(file_name, image, [&](int y) -> Result<Image<float>> {
            const PictureBand band = *std::ranges::find(bands, y, &PictureBand::top);
            Image<float> all;
            for (const Exposure& one : shown) {
                TRY(rows, draw_band(*session.renderer, one, band));
                all = all.empty() ? std::move(*rows) : side_by_side(all, *rows);
            }
            print_notes(session);
            progress.advance(band.rows);
            return all;
        }));
    return made_by(session);
}

Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured,
                     const CaptureOptions& options, std::optional<int> frame) {
    if (file_name.ends_with(".jpg") || file_name.ends_with(".jpeg"))
        return save_jpeg(file_name, captured.display, fmt::format("{}\nnullscope {}", scene.name, kVersion),
                         options.quality.value_or(kJpegQuality));
    if (file_name.ends_with(".fits")) {
        const auto flux = flux_unit(scene, is_several(scene, options));
        return save_fits(file_name, flux ? in_jansky(captured.linear, *flux) : captured.linear,
                         header_of(scene, captured, options, frame));
    }
    std::map<std::string, std::string> words = words_of(scene, captured.made_by, frame);
    if (!file_name.ends_with(".exr")) {
        words.erase("nullscope.renderer");  // the same picture is the same file
        words.insert({{"Title", scene.name}, {"Software", fmt::format("nullscope {}", kVersion)}});
        return save_png(file_name, captured.display, words);
    }
    if (options.half)
        return save_exr_bands(file_name, {captured.linear.width, captured.linear.height, true, std::move(words)},
                              [&](int) -> Result<Image<float>> { return captured.linear; });
    ChannelImage file{captured.linear.width, captured.linear.height, {}, {}};
    for (int c = 0; c < 3; ++c) file.channels[std::string(1, "RGB"[c])] = channel_of(captured.linear, c);
    if (captured.rays) add_ray_channels(*captured.rays, file);
    if (captured.layers) add_layer_channels(*captured.layers, scene, file);
    file.attributes = std::move(words);
    return save_exr(file_name, file);
}

}  // namespace nullscope::cli
