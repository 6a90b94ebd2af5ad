#include "command/sky_light.h"

#include <fmt/format.h>

#include <cmath>

#include "image/luminance.h"
#include "render/picture_layers.h"
#include "scene/medium_bands.h"

namespace nullscope::cli {
namespace {

Image<float> luminance_image(const Image<float>& light) {
    Image<float> luminance(light.width, light.height, 1);
    for (std::size_t i = 0; i < luminance.data.size(); ++i) luminance.data[i] = luminance_of(&light.data[3 * i]);
    return luminance;
}

// Angles from north, which is up, through east, left, instead of from right towards up: a quarter turn less, the same sense.
Image<float> turned_to_north(Image<float> stokes) {
    for (std::size_t i = 0; i < stokes.data.size(); i += kStokesParameters)
        stokes.data[i + 1] = -stokes.data[i + 1], stokes.data[i + 2] = -stokes.data[i + 2];
    return stokes;
}

Image<float> times(Image<float> image, double factor) {
    for (float& value : image.data) value = static_cast<float>(factor * value);
    return image;
}

// Its I adds up to 1 where it is not in Jy. Error: it is dark.
Result<SkyLight> lit(SkyLight light, const std::string& file) {
    const double sum = total_flux(light.picture);
    if (!(sum > 0)) {
        Error error = bad_input(fmt::format("its light adds up to {:g}", sum), "above 0");
        error.file = file;
        return error;
    }
    if (!light.in_jansky)
        for (double& value : light.picture.flux.data) value /= sum;
    return light;
}

}  // namespace

Image<float> sky_planes(const Captured& captured, const std::optional<FluxUnit>& unit) {
    if (!captured.stokes.empty())
        return turned_to_north(unit ? times(captured.stokes, unit->luminance_jansky) : captured.stokes);
    return unit ? in_jansky(captured.linear, *unit) : luminance_image(captured.linear);
}

Image<float> sky_planes(const BandPicture& band, double unit) {
    return band.stokes.empty() ? times(band.light, unit) : turned_to_north(times(band.stokes, unit));
}

Status one_frequency(const Scene& scene) {
    if (!shows_bands(scene)) return Done{};
    return bad_key("medium.frequency", "the picture shows several frequencies as colours", "one, or shown_band");
}

Result<double> sky_scale(const Scene& scene) {
    if (const auto pixel = pixel_on_sky(scene)) return *pixel;
    return bad_input(
        "the picture has no scale on the sky of Earth",
        "an [object] with mass and distance, seen by a pinhole camera at rest at r >= 20 that looks at the "
        "centre");
}

Result<SkyLight> sky_light(const Scene& scene, const Captured& captured) {
    TRY(pixel, sky_scale(scene));
    TRY(alone, one_frequency(scene));
    const auto unit = flux_unit(scene, false);
    const Image<float> planes = sky_planes(captured, unit);
    SkyLight light;
    light.picture = {Image<double>(planes.width, planes.height, planes.channels), *pixel};
    light.picture.flux.data.assign(planes.data.begin(), planes.data.end());
    light.in_jansky = unit.has_value();
    if (unit) light.frequency_GHz = unit->frequency_GHz;
    if (const KnownObject* known = known_object(scene.object.name)) light.place = known->place;
    return lit(std::move(light), "");
}

Result<SkyLight> sky_light(const FitsPicture& fits, const std::string& file) {
    const auto fault = [&](const char* card, const std::string& what, const char* allowed) {
        return Error{ErrorKind::kBadInput, what, allowed, card, file};
    };
    const auto east = fits.number("CDELT1"), north = fits.number("CDELT2");
    if (!east) return fault("CDELT1", "this card is missing", "degrees a pixel");
    if (!north) return fault("CDELT2", "this card is missing", "degrees a pixel");
    constexpr double kLargest = 1.0, kSame = 1e-9;  // degrees; relative
    if (!(*north > 0 && *north <= kLargest))
        return fault("CDELT2", fmt::format("{} is out of range", *north), "(0, 1]");
    if (!(std::fabs(*east / *north + 1) <= kSame))
        return fault("CDELT1", fmt::format("{}: pixels are not square, or east is not left", *east), "-CDELT2");
    for (const char* card : {"PC1_2", "PC2_1", "CROTA2"})
        if (fits.number(card).value_or(0) != 0) return fault(card, "the picture is turned", "0: north is up");
    SkyLight light;
    light.picture = {fits.planes, *north * M_PI / 180};
    light.in_jansky = fits.text("BUNIT") == "Jy/pixel" || fits.text("BUNIT") == "JY/PIXEL";
    if (const auto frequency = fits.number("FREQ"); frequency && *frequency > 0)
        light.frequency_GHz = 1e-9 * *frequency;
    const auto right_ascension = fits.number("CRVAL1"), declination = fits.number("CRVAL2");
    if (right_ascension && declination) light.place = SkyPlace{*right_ascension, *declination};
    return lit(std::move(light), file);
}

}  // namespace nullscope::cli
