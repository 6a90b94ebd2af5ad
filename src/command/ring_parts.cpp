#include "command/ring_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "observer/critical_light.h"
#include "scene/pixel_mesh.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

using Point =
    std::array<double, 2>;  // in the plane that the camera's line of sight meets at the distance 1, right and up

Error no_band(const std::string& what, const std::string& allowed) { return bad_input("--rings: " + what, allowed); }

// The critical curve as the camera sees it, at even angles about the middle of its extent.
class CurveAngles {
public:
    explicit CurveAngles(const CriticalLight& light) : light_(light) {
        Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
        for (int i = 0; i <= kSamples; ++i) {
            const Point at = point(parameter(i));
            for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
        }
        middle_ = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
        for (int i = 0; i <= kSamples; ++i) angles_.push_back(angle(parameter(i)));
    }

    // Nothing: some angle does not meet it.
    std::optional<ClosedCurve> at_even_angles(int count) const {
        ClosedCurve curve{middle_, {}};
        for (int i = 0; i < count; ++i) {
            const auto met = parameter_at(2 * M_PI * i / count);
            if (!met) return std::nullopt;
            const Point at = point(*met);
            curve.radius.push_back(std::hypot(at[0] - middle_[0], at[1] - middle_[1]));
        }
        return curve;
    }

private:
    static constexpr int kSamples = 360, kHalvings = 45;
    static double parameter(double sample) { return 2 * M_PI * sample / kSamples; }
    Point point(double parameter) const {
        const Vec3 d = light_.direction(parameter);
        return d.z < 0 ? Point{-d.x / d.z, -d.y / d.z} : Point{NAN, NAN};
    }
    double angle(double parameter) const {
        const Point at = point(parameter);
        return std::atan2(at[1] - middle_[1], at[0] - middle_[0]);
    }
    static double apart(double angle, double wanted) { return std::remainder(angle - wanted, 2 * M_PI); }

    std::optional<double> parameter_at(double wanted) const {
        for (std::size_t i = 0; i + 1 < angles_.size(); ++i) {
            const double before = apart(angles_[i], wanted), after = apart(angles_[i + 1], wanted);
            if (!(before * after <= 0 && std::fabs(before - after) < 1)) continue;
            double low = static_cast<double>(i), high = low + 1;
            for (int k = 0; k < kHalvings; ++k) {
                const double half = 0.5 * (low + high);
                (apart(angle(parameter(half)), wanted) * before > 0 ? low : high) = half;
            }
            return parameter(0.5 * (low + high));
        }
        return std::nullopt;
    }

    const CriticalLight& light_;
    Point middle_{};
    std::vector<double> angles_;
};

Result<ClosedCurve> curve_seen(const Scene& scene, int count) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto light = spacetime ? CriticalLight::make(**spacetime, scene.camera, scene.light) : std::nullopt;
    if (!light) return no_band("the scene has no critical curve", "of a hole whose light is bent");
    auto curve = CurveAngles(*light).at_even_angles(count);
    if (!curve) return no_band("the critical curve is not all before the camera", "a view from afar");
    return std::move(*curve);
}

// Where the grid has a point, px.
Point pixel_at(const CameraSpec& camera, Point at) {
    const Point sight = line_of_sight(camera);
    return {sight[0] + at[0] / camera.pixel(), sight[1] - at[1] / camera.pixel()};
}

Status check_held(const CameraSpec& camera, const RingChart& chart) {
    for (int angle = 0; angle < chart.around(); ++angle) {
        const auto [x, y] = pixel_at(camera, chart.place(chart.across() - 1, angle).at);
        if (!(x >= 0 && y >= 0 && x <= camera.width && y <= camera.height))
            return no_band("the picture does not hold the band along the critical curve",
                           fmt::format("at least {:.3g} of its radii to every side", 1 + RingChart::kEnd[1]));
    }
    return Done{};
}

// Its pixels are the chart's places, one row for each angle. They are points: of a projection whose pixels are this share of the curve's
// radius, a hundredth of how far the images n = 3 of Schwarzschild's hole are from it; its tables are as fine there.
CameraSpec band_camera(CameraSpec camera, const RingChart& chart) {
    constexpr double kPixel = 1e-6;
    camera.width = chart.across(), camera.height = chart.around();
    camera.plane_width = kPixel * chart.reach() * camera.focal_distance * camera.width;
    camera.shift_x = camera.shift_y = 0;
    camera.warp_intensity = WarpIntensity::kLinear;
    return camera;
}

WarpMesh band_mesh(const CameraSpec& camera, const RingChart& chart) {
    std::vector<Point> places;
    places.reserve(static_cast<std::size_t>(chart.across()) * static_cast<std::size_t>(chart.around()));
    for (int angle = 0; angle < chart.around(); ++angle)
        for (int number = 0; number < chart.across(); ++number) {
            const Point at = chart.place(number, angle).at;
            places.push_back(
                {0.5 + at[0] / (camera.pixel() * camera.width), 0.5 + at[1] / (camera.pixel() * camera.height)});
        }
    return WarpMesh::of_pixels(places, camera.width, camera.height);
}

Result<Captured> drawn_band(const Shot& shot, Session* session, const Exposure& shown, DrawOptions drawing,
                            const RingChart& chart) {
    CameraSpec camera = band_camera(shown.scene.camera, chart);
    const HeldMesh mesh(band_mesh(camera, chart));
    camera.warp = mesh.name();
    const auto along_curve = [&](Scene scene) {
        scene.camera = camera;
        scene.picture.samples = 1;
        scene.picture.refine = false;
        return scene;
    };
    drawing.samples = 1;
    return draw_shot(shot, session, changed(shown, along_curve), drawing, false);
}

// planes: of light on an area as large as the grid's pixel.
LightPoints band_points(const CameraSpec& camera, const RingChart& chart, const Image<float>& planes, double pixel) {
    LightPoints points(planes.channels);
    for (int angle = 0; angle < chart.around(); ++angle)
        for (int number = 0; number < chart.across(); ++number) {
            const RingChart::Place place = chart.place(number, angle);
            const auto [x, y] = pixel_at(camera, place.at);
            const double share = place.window * place.area / (camera.pixel() * camera.pixel());
            std::array<double, 4> light{};
            for (int plane = 0; plane < planes.channels; ++plane)
                light[static_cast<std::size_t>(plane)] = share * planes.at(number, angle)[plane];
            points.add(pixel * (0.5 * camera.width - x), pixel * (0.5 * camera.height - y), light,
                       (number + angle) % 2 != 0);
        }
    return points;
}

double whole_of(const Image<float>& planes) {
    double sum = 0;
    for (std::size_t i = 0; i < planes.data.size(); i += static_cast<std::size_t>(planes.channels))
        sum += planes.data[i];
    return sum;
}

// Both parts are 1 together.
void share_out(SkyParts& parts) {
    const double whole = total_flux(parts.grid.picture) + parts.band.whole();
    parts.share = 1 / whole;
    for (double& light : parts.grid.picture.flux.data) light /= whole;
    parts.band.scale(1 / whole);
}

int angles_for(double longest, double pixel, const CameraSpec& camera) {
    // Fringes of a baseline along a circle about the picture: 2 pi of those across its radius, each way.
    constexpr double kPlacesPerFringe = 4.0;
    const double across = pixel * 0.5 * std::min(camera.width, camera.height),
                 wanted = kPlacesPerFringe * 2 * M_PI * longest * across;
    return 2 * static_cast<int>(std::clamp(0.5 * wanted, 0.5 * kLeastAround, 0.5 * kMostAround));
}

}  // namespace

Result<RingChart> ring_chart(const Scene& scene, double longest) {
    const CameraSpec& camera = scene.camera;
    if (camera.zoom || camera.part || !camera.warp.empty())
        return no_band("the picture is a part of a view, or bent", "no [zoom] and no camera.warp");
    TRY(pixel, sky_scale(scene));
    TRY(curve, curve_seen(scene, angles_for(longest, *pixel, camera)));
    RingChart chart(std::move(*curve), kBandAcross);
    TRY(held, check_held(camera, chart));
    return chart;
}

void take_band(const CameraSpec& camera, const RingChart& chart, SkyPicture& picture) {
    Image<double>& light = picture.flux;
    const Point sight = line_of_sight(camera);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            const double left =
                1 - chart.window((x + 0.5 - sight[0]) * camera.pixel(), (sight[1] - y - 0.5) * camera.pixel());
            for (int plane = 0; plane < light.channels; ++plane) light.at(x, y)[plane] *= left;
        }
}

Result<SkyParts> sky_parts(const Shot& shot, Session* session, const Exposure& shown, const DrawOptions& drawing,
                           const Captured& captured, const RingChart& chart) {
    const CameraSpec& camera = shown.scene.camera;
    TRY(grid, sky_light(shown.scene, captured));
    TRY(band, drawn_band(shot, session, shown, drawing, chart));
    const Image<float> planes = sky_planes(*band, flux_unit(shown.scene, false));
    const double pixel = grid->picture.pixel;
    SkyParts parts{std::move(*grid), band_points(camera, chart, planes, pixel), chart.across(), chart.around()};
    take_band(camera, chart, parts.grid.picture);
    if (!parts.grid.in_jansky) {
        parts.band.scale(1 / whole_of(sky_planes(captured, std::nullopt)));
        share_out(parts);
    }
    return parts;
}

}  // namespace nullscope::cli
