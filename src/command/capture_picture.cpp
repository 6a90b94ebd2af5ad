#include "command/capture_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "command/band_pictures.h"
#include "command/capture_layers.h"
#include "command/reference_inputs.h"
#include "image/picture_formats.h"
#include "reference/reference.h"
#include "render/display.h"
#include "render/picture_bands.h"

namespace nullscope::cli {
namespace {

// Of bands that draw(band) gives.
template <class T, class Draw>
Result<Image<T>> large_picture(Session& session, const CameraSpec& camera, const Listener& listener, Draw draw) {
    Image<T> picture(camera.width, camera.height, 3);
    const Advance advance = listener.progress("large picture", camera.height);
    for (const PictureBand& band : picture_bands(camera)) {
        TRY(rows, draw(band));
        tell_notes(session, listener);
        std::ranges::copy(rows->data, picture.at(0, band.top));
        advance(band.rows);
    }
    return picture;
}

// 8 bits a colour: a picture of 16384x16384 px is held.
Result<Image<unsigned char>> picture8(Session& session, const Exposure& shown, const Listener& listener) {
    if (!is_drawn_in_bands(shown.scene)) return draw_picture8(*session.renderer, shown);
    const CameraSpec& camera = shown.scene.camera;
    if (Status fits = check_size8(camera.width, camera.height); !fits) return fits.error();
    return large_picture<unsigned char>(
        session, camera, listener, [&](const PictureBand& band) { return draw_band8(*session.renderer, shown, band); });
}

Status draw_bytes(Session& session, const Exposure& shown, const DrawOptions& options, Captured& captured) {
    if (options.in_flight && !is_drawn_in_bands(shown.scene)) {
        TRY(coming, begin_picture8(*session.renderer, shown));
        captured.coming = std::move(*coming);
    } else {
        TRY(picture, picture8(session, shown, options.listener));
        captured.bytes = std::move(*picture);
    }
    return Done{};
}

Result<Image<float>> linear_picture(Session& session, const Exposure& shown, const DrawOptions& options) {
    if (!options.in_bands || !is_drawn_in_bands(shown.scene)) return draw_picture(*session.renderer, shown);
    return large_picture<float>(session, shown.scene.camera, options.listener,
                                [&](const PictureBand& band) { return draw_band(*session.renderer, shown, band); });
}

// What is displayed of linear light.
void encode(const Scene& scene, Sample sample, Captured& captured) {
    const double exposure = scene.camera.exposure_ev;
    if (sample == Sample::kByte) captured.bytes = display_encoded(captured.linear, exposure, scene.picture);
    if (sample == Sample::kWord) captured.words = display_encoded16(captured.linear, exposure, scene.picture);
}

BandDrawing drawing_of_bands(Session& session, const Exposure& shown, const DrawOptions& options) {
    BandDrawing draw{[&](const Exposure& one) { return linear_picture(session, one, options); }, nullptr};
    if (!is_drawn_in_bands(shown.scene))
        draw.stokes = [&](const Exposure& one) -> Result<Image<float>> {
            TRY(ready, session.renderer->prepare(one.scene));
            return draw_stokes(*session.renderer);
        };
    return draw;
}

Result<Captured> capture_gl(Session& session, const Exposure& shown, const DrawOptions& options, const Scene* next) {
    begin_drawing(session, options);
    Captured captured;
    if (options.layers) {
        TRY(layers, capture_layers(session, shown.scene, next));
        captured.linear = std::move(layers->layers.all);
        captured.layers = std::move(*layers);
    } else if (!options.st_map.empty()) {
        TRY(ready, session.renderer->prepare(behind_things(shown.scene).value_or(shown.scene)));
        captured.linear = st_map_of(session.renderer->ray_data(), shown.scene, options.st_map);
    } else if (options.sample != Sample::kByte) {
        TRY(light, linear_picture(session, shown, options));
        captured.linear = std::move(*light);
        encode(shown.scene, options.sample, captured);
    } else {
        TRY(drawn, draw_bytes(session, shown, options, captured));
    }
    if (captured.layers) {
        captured.stokes = captured.layers->layers.stokes;
    } else if (options.stokes && options.st_map.empty() && is_polarised(shown.scene) &&
               !is_drawn_in_bands(shown.scene)) {
        TRY(ready, session.renderer->prepare(shown.scene));
        captured.stokes = draw_stokes(*session.renderer);
    }
    tell_notes(session, options.listener);
    if (options.raydata && !options.layers) captured.rays = session.renderer->ray_data();  // layers have them
    if (options.bands && options.st_map.empty()) {
        TRY(bands, band_pictures(shown, drawing_of_bands(session, shown, options), captured.linear));
        captured.bands = std::move(*bands);
    }
    captured.made_by = made_by(session);
    return captured;
}

long long pixels_of(const Scene& scene) { return static_cast<long long>(scene.camera.width) * scene.camera.height; }

constexpr const char* kReference = "reference tracer";

Result<RayFrame> reference_rays(const Scene& scene, const Listener& listener) {
    return reference::trace_frame(scene, listener.progress("reference ray data", pixels_of(scene)));
}

// What the reference has of a scene's files.
struct Inputs {
    std::unique_ptr<const ReferenceInputs> loaded;
    std::vector<PointStar> stars;
};

// A zoom leaves stars as bright as they are without it (render/frame_numbers.cpp).
std::vector<PointStar> stars_of(const Inputs& inputs, const Scene& scene) {
    std::vector<PointStar> stars = inputs.stars;
    if (!scene.camera.zoom) return stars;
    for (PointStar& star : stars) star.flux *= std::exp(-2.0 * scene.camera.zoom->depth);
    return stars;
}

Result<Captured> capture_reference(const Inputs& inputs, const Exposure& shown, const DrawOptions& options) {
    const Scene& scene = shown.scene;
    Captured captured;
    const auto light_of = [&](const Exposure& one) {
        const auto pictures = std::max(std::ssize(one.sub_frames), std::ptrdiff_t{1});
        const Advance advance = options.listener.progress("reference picture", pixels_of(scene) * pictures);
        return mean_light(one, [&](const Scene& each) {
            return reference::render_frame(each, inputs.loaded->sky, inputs.loaded->pictures(each),
                                           options.samples.value_or(kSamples), advance, inputs.loaded->far(),
                                           stars_of(inputs, each));
        });
    };
    TRY(image, light_of(shown));
    captured.linear = std::move(*image);
    if (options.bands) {
        TRY(bands, band_pictures(shown, {light_of, nullptr}, captured.linear));
        captured.bands = std::move(*bands);
    }
    if (options.raydata) {
        TRY(rays, reference_rays(scene, options.listener));
        captured.rays = std::move(*rays);
    }
    encode(scene, options.sample, captured);
    captured.made_by = kReference;
    return captured;
}

// No picture of the sky is loaded for it.
Result<Captured> reference_st_map(const Scene& scene, const DrawOptions& options) {
    TRY(rays, reference_rays(behind_things(scene).value_or(scene), options.listener));
    Captured captured;
    captured.linear = st_map_of(*rays, scene, options.st_map);
    captured.made_by = kReference;
    return captured;
}

}  // namespace

void Captured::arrive() {
    if (const auto read = std::exchange(coming, std::nullopt)) bytes = read->take();
}

int Captured::width() const { return coming ? coming->width : std::max(bytes.width, words.width); }
int Captured::height() const { return coming ? coming->height : std::max(bytes.height, words.height); }

void begin_drawing(Session& session, const DrawOptions& options) {
    session.renderer->want_delays(options.raydata || options.layers);
    if (options.largest_texture) session.renderer->limit_pictures(*options.largest_texture);
}

std::string made_by(const Session& session) {
    return session.context->kind() + ", " + session.renderer->info().renderer +
           (session.renderer->computed().draws() ? ", compute" : "");
}

void tell_notes(Session& session, const Listener& listener) {
    for (const std::string& note : session.renderer->take_notes()) listener.note(note);
}

Status check_size8(int width, int height) {
    constexpr long long kMostBytes = std::numeric_limits<int>::max();  // of the packages that write it
    if (3LL * width * height <= kMostBytes) return Done{};
    const std::string displayed =
        format_endings(" and ", [](const PictureFormat& format) { return format.sample != Sample::kLight; });
    return bad_input(fmt::format("a picture of {}x{} px is too large for {}", width, height, displayed),
                     fmt::format("{} million pixels, or -o FILE.exr", kMostBytes / 3'000'000));
}

Result<PictureDrawer> picture_drawer(Session* session, const Scene& scene, const DrawOptions& options) {
    if (session != nullptr)
        return PictureDrawer(
            [session, options](const Exposure& shown) { return capture_gl(*session, shown, options, nullptr); });
    TRY(loaded, load_reference_inputs(scene));
    for (const std::string& note : (*loaded)->notes) options.listener.note(note);
    TRY(stars, point_stars(scene.sky, assets_directory()));
    const auto inputs = std::make_shared<const Inputs>(Inputs{std::move(*loaded), std::move(*stars)});
    return PictureDrawer(
        [inputs, options](const Exposure& shown) { return capture_reference(*inputs, shown, options); });
}

Result<Captured> capture_picture(Session* session, const Exposure& shown, const DrawOptions& options,
                                 const Scene* next) {
    if (session != nullptr) return capture_gl(*session, shown, options, next);
    if (!options.st_map.empty()) return reference_st_map(shown.scene, options);
    TRY(draw, picture_drawer(nullptr, shown.scene, options));
    return (*draw)(shown);
}

}  // namespace nullscope::cli
