#include "telescope/live_source.h"

#include <cmath>

#include "annotate/annotations.h"
#include "image/luminance.h"
#include "observer/picture_scale.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kMicroarcsecond = M_PI / 180 / 3600e6;  // rad

// By the formula for cameras far away, wherever there is one.
std::optional<double> rough_pixel(const Scene& scene) {
    const CameraSpec& camera = scene.camera;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto microarcsecond = length_of_microarcsecond(scene.object);
    if (!spacetime || !microarcsecond || !has_scale(**spacetime)) return std::nullopt;
    if (!projection_of(camera).flat || camera.pixel_aspect != 1.0) return std::nullopt;
    const double lapse = (*spacetime)->lapse_squared(camera.r);
    if (!(lapse > 0) || !(camera.r > 0)) return std::nullopt;
    return camera.pixel() * (*spacetime)->areal_radius(camera.r) / std::sqrt(lapse) / *microarcsecond * kMicroarcsecond;
}

}  // namespace

Result<LiveSource> live_source(const Scene& scene) {
    Scene seen = scene;
    LiveSource source;
    source.assumed_object = !scene.object.mass() || !scene.object.distance();
    if (source.assumed_object) seen.object = ObjectSpec(), seen.object.name = ObjectName::kM87;
    const KnownObject *known = known_object(seen.object.name), *usual = known_object(ObjectName::kM87);
    source.object = known != nullptr ? known->name : "the scene's object";
    source.mass_suns = *seen.object.mass();
    source.assumed_place = source.assumed_object || known == nullptr || !known->place;
    source.place = source.assumed_place ? *usual->place : *known->place;
    const auto exact = pixel_on_sky(seen), pixel = exact ? exact : rough_pixel(seen);
    if (!pixel) return bad_input("the picture has no scale", "a pinhole camera outside the horizon, in no wormhole");
    source.pixel = *pixel, source.rough = !exact;
    if (!source.assumed_object) source.unit = flux_unit(seen, false);
    if (source.unit) source.frequency_GHz = source.unit->frequency_GHz;
    return source;
}

SkyPicture live_picture(const Image<float>& linear, const LiveSource& source) {
    SkyPicture picture{Image<double>(linear.width, linear.height, 1), source.pixel};
    std::vector<double>& flux = picture.flux.data;
    double sum = 0;
    for (std::size_t i = 0; i < flux.size(); ++i) {
        const float* rgb = &linear.data[3 * i];
        flux[i] = source.unit ? source.unit->jansky * rgb[source.unit->channel] : luminance_of(rgb);
        sum += flux[i];
    }
    if (!source.unit && sum > 0)
        for (double& value : flux) value /= sum;
    return picture;
}

}  // namespace nullscope
