#include "cli/picture_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "command/band_pictures.h"
#include "command/derivative_channels.h"
#include "command/fits_header.h"
#include "command/sky_light.h"
#include "compare/ray_channels.h"
#include "compare/rotation_measure.h"
#include "image/channels.h"
#include "image/half_float.h"
#include "image/image_file.h"
#include "image/picture_formats.h"
#include "render/picture_bands.h"
#include "scene/medium_bands.h"
#include "telescope/flux.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

// By which driver, whatever context it is in: EGL and OSMesa have the same one.
Result<std::map<std::string, std::string>> words_of(PictureOrigin origin, std::string_view made_by,
                                                    bool displayed = false) {
    for (const std::string& kind : context_kinds())
        if (made_by.starts_with(kind + ", ")) made_by.remove_prefix(kind.size() + 2);
    origin.renderer = made_by;
    origin.version = kVersionText;
    return displayed ? displayed_picture_words(origin) : picture_words(origin);
}

void say_halves(const std::string& file, std::size_t beyond, const Listener& listener) {
    if (beyond > 0)
        listener.note(fmt::format("{}: {} numbers above {:g}, the largest half float, are written as that", file,
                                  beyond, kMostHalf));
}

FitsHeader header_of(const PictureOrigin& origin, const Captured& captured, const std::optional<FluxUnit>& flux,
                     bool several, std::map<std::string, std::string> words) {
    const Scene& scene = origin.scene;
    FitsHeader header{.unit_comment = "relative luminance: linear light, 1 is white"};
    if (flux) {
        header.unit = "Jy/pixel", header.unit_comment = "flux density of a pixel";
        header.cards.push_back({"FREQ", 1e9 * flux->frequency_GHz, "[Hz] as the camera sees it"});
    }
    add_coordinates(scene, several, header);
    add_scene(scene, header);
    for (const char* key : {"TELESCOP", "ORIGIN"}) header.cards.push_back({key, "nullscope", ""});
    header.cards.push_back({"CREATOR", fmt::format("nullscope {}", kVersionText), "program and version"});
    header.cards.push_back({"RENDERER", captured.made_by, ""});
    header.cards.push_back({"SCENE", scene.name, ""});
    header.cards.push_back({"SCENHASH", words["nullscope.scene_hash"], "FNV-1a of its text, which is in HISTORY"});
    if (origin.frame) header.cards.push_back({"FRAME", static_cast<long long>(*origin.frame), "of a sequence"});
    header.texts = std::move(words);
    return header;
}

// A file of linear light, which says more of its scene than words.
struct LightFile {
    const std::string& name;
    const PictureOrigin& origin;
    const Captured& captured;
    const CaptureOptions& options;
    std::map<std::string, std::string> words;
};

std::string file_of_band(std::string_view file_name, double frequency) {
    const std::filesystem::path path(file_name);
    return (path.parent_path() /
            fmt::format("{}-{}{}", path.stem().string(), band_name(frequency), path.extension().string()))
        .string();
}

// A file for each frequency: fluxes in Jy, or brightness temperatures.
Status write_fits_of_bands(const LightFile& file, bool several) {
    const auto units = band_units(file.origin.scene, several);
    for (std::size_t i = 0; i < file.captured.bands.size(); ++i) {
        const BandPicture& band = file.captured.bands[i];
        FitsHeader header = header_of(file.origin, file.captured, units[i], several, file.words);
        if (!units[i]) {
            header.unit = "K", header.unit_comment = "brightness temperature (Rayleigh and Jeans)";
            header.cards.insert(header.cards.begin(),
                                FitsCard{"FREQ", 1e9 * band.frequency_GHz, "[Hz] as the camera sees it"});
        }
        const double unit = units[i] ? units[i]->jansky : kMediumLight_K;
        TRY(saved, save_fits(file_of_band(file.name, band.frequency_GHz), sky_planes(band, unit), header));
    }
    return Done{};
}

Status write_fits(LightFile file) {
    const Scene& scene = file.origin.scene;
    const bool several = !file.options.split.empty() || scene.split || scene.camera.stereo != Stereo::kOff;
    if (!file.captured.bands.empty()) return write_fits_of_bands(file, several);
    const auto flux = flux_unit(scene, several);
    const FitsHeader header = header_of(file.origin, file.captured, flux, several, std::move(file.words));
    return save_fits(file.name, sky_planes(file.captured, flux), header, flux ? Image<float>() : file.captured.linear);
}

// What the displayed picture shows, before its sRGB encoding.
Image<float> displayed_light(const Image<unsigned short>& words) {
    Image<float> light(words.width, words.height, 3);
    std::ranges::transform(words.data, light.data.begin(),
                           [](unsigned short code) { return linear_from_srgb(static_cast<float>(code) / 65535.0f); });
    return light;
}

// The primaries of an EXR's colours; none: Rec. 709's, which are those of all that is drawn.
std::optional<Primaries> primaries_of(const CaptureOptions& options) {
    return options.colour == "acescg" ? std::optional(kAcesCgPrimaries) : std::nullopt;
}

void convert_light(float& red, float& green, float& blue, const Mat3& matrix) {
    const Vec3 light = matrix * Vec3{red, green, blue};
    red = static_cast<float>(light.x), green = static_cast<float>(light.y), blue = static_cast<float>(light.z);
}

void convert_to(const Primaries& primaries, Image<float>& image) {
    const Mat3 matrix = light_matrix(kRec709Primaries, primaries);
    for (std::size_t i = 0; i + 2 < image.data.size(); i += 3)
        convert_light(image.data[i], image.data[i + 1], image.data[i + 2], matrix);
}

// The colours of the picture and of its layers.
void convert_to(const Primaries& primaries, ChannelImage& image) {
    const Mat3 matrix = light_matrix(kRec709Primaries, primaries);
    for (auto& [name, red] : image.channels) {
        if (name != "R" && !name.ends_with(".R")) continue;
        const std::string layer = name.substr(0, name.size() - 1);
        std::vector<float>&green = image.channels.at(layer + "G"), &blue = image.channels.at(layer + "B");
        for (std::size_t i = 0; i < red.size(); ++i) convert_light(red[i], green[i], blue[i], matrix);
    }
}

// "band.86GHz.I", and of polarised light .Q, .U, .V and the rotation measure.
void add_bands(const std::vector<BandPicture>& bands, ChannelImage& channels) {
    for (const BandPicture& band : bands) {
        const std::string layer = fmt::format("band.{}.", band_name(band.frequency_GHz));
        channels.channels[layer + 'I'] = channel_of(band.light, 0);
        for (int c = 1; !band.stokes.empty() && c < kStokesParameters; ++c)
            channels.channels[layer + "IQUV"[c]] = channel_of(band.stokes, c);
    }
    if (const Image<float> rm = rotation_measure_image(bands); !rm.empty()) channels.channels["rm"] = channel_of(rm, 0);
}

Status write_exr(LightFile file) {
    const Captured& captured = file.captured;
    const Image<float> displayed = file.options.to_displayed_light() ? displayed_light(captured.words) : Image<float>();
    const Image<float>& light = displayed.empty() ? captured.linear : displayed;
    const std::optional<Primaries> primaries = primaries_of(file.options);
    if (file.options.half) {
        Image<float> colours = light;
        if (primaries) convert_to(*primaries, colours);
        say_halves(file.name, count_beyond_half(colours.data), file.options.listener);
        return save_exr_bands(file.name, {light.width, light.height, true, std::move(file.words), primaries},
                              [&](int) -> Result<Image<float>> { return std::move(colours); });
    }
    ChannelImage channels{light.width, light.height, {}, {}};
    add_bands(captured.bands, channels);
    for (int c = 0; c < 3; ++c) channels.channels[std::string(1, "RGB"[c])] = channel_of(light, c);
    if (captured.rays) add_ray_channels(*captured.rays, RayNames::kAlone, channels);
    if (captured.rays && !file.options.derivatives.empty()) {
        const Advance advance = file.options.listener.progress("derivatives", captured.rays->height);
        TRY(added, add_derivative_channels(file.origin.scene, nullscope::split(file.options.derivatives, ','),
                                           *captured.rays, advance, channels));
    }
    if (captured.layers) add_layer_channels(*captured.layers, file.origin.scene, channels);
    if (!captured.stokes.empty())
        for (int c = 0; c < kStokesParameters; ++c)
            channels.channels[std::string("stokes.") + "IQUV"[c]] = channel_of(captured.stokes, c);
    if (primaries) convert_to(*primaries, channels);
    channels.primaries = primaries;
    channels.attributes = std::move(file.words);
    return save_exr(file.name, channels);
}

// Of the formats that write no DisplayedPicture.
struct LightWriter {
    const PictureFormat* format;
    Status (*write)(LightFile);
};
constexpr LightWriter kLightWriters[] = {{&kExrFormat, write_exr}, {&kFitsFormat, write_fits}};

}  // namespace

Result<std::string> capture_large_exr(Session& session, const PictureOrigin& origin, const std::vector<Exposure>& shown,
                                      const CaptureOptions& options, const std::string& file_name) {
    const CameraSpec& camera = shown.front().scene.camera;
    begin_drawing(session, options.drawing());
    const std::vector<PictureBand> bands = picture_bands(camera);
    const Advance advance = options.listener.progress("large picture", camera.height);
    TRY(words, words_of(origin, made_by(session)));
    const BandedImage image{camera.width * static_cast<int>(shown.size()), camera.height, options.half,
                            std::move(*words), primaries_of(options)};
    std::size_t beyond = 0;
    TRY(saved, save_exr_bands(file_name, image, [&](int y) -> Result<Image<float>> {
            const PictureBand band = *std::ranges::find(bands, y, &PictureBand::top);
            Image<float> all;
            for (const Exposure& one : shown) {
                TRY(rows, draw_band(*session.renderer, one, band));
                all = all.empty() ? std::move(*rows) : side_by_side(all, *rows);
            }
            tell_notes(session, options.listener);
            advance(band.rows);
            if (image.primaries) convert_to(*image.primaries, all);
            beyond += count_beyond_half(all.data);
            return all;
        }));
    if (options.half) say_halves(file_name, beyond, options.listener);
    if (has_bands(origin.scene))
        options.listener.note(fmt::format("{}: with --half no frequency has a channel of its own", file_name));
    return made_by(session);
}

Status write_picture(const std::string& file_name, const PictureOrigin& origin, const Captured& captured,
                     const CaptureOptions& options) {
    const PictureFormat* format = format_named(file_name);
    TRY(words, words_of(origin, captured.made_by, format->save != nullptr));
    if (format->save != nullptr)
        return format->save(file_name, {captured.bytes, captured.words, origin.scene.name,
                                        fmt::format("nullscope {}", kVersion), options.quality, *words});
    const auto writer = std::ranges::find(kLightWriters, format, &LightWriter::format);
    return writer->write({file_name, origin, captured, options, std::move(*words)});
}

std::string files_of(const std::string& file_name, const Scene& scene, const CaptureOptions& options) {
    const bool alone = options.split.empty() && !scene.split && scene.camera.stereo == Stereo::kOff;
    if (format_named(file_name) != &kFitsFormat || !has_bands(scene) || !alone) return file_name;
    std::vector<std::string> names;
    for (const double frequency : scene.medium->bands_GHz) names.push_back(band_name(frequency));
    const std::filesystem::path path(file_name);
    return (path.parent_path() /
            fmt::format("{}-{{{}}}{}", path.stem().string(), fmt::join(names, ","), path.extension().string()))
        .string();
}

}  // namespace nullscope::cli
