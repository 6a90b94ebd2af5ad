#include "proof/view_judge.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shadercore/core_trace.h"

namespace nullscope::proof {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kBearings = 16;
// About a rotating hole rays go by steps, not by tables: what is promised of them, 0.05 px of a 1080p frame over 60 degrees.
constexpr double kStepped_rad = 0.05 * M_PI / 3 / 1920;
constexpr double kRings[] = {0.03, 0.1, 0.3, 1.0};

}  // namespace

const std::vector<Core>& cores() {
    static const std::vector<Core> list = {
        {"core64", trace_core64, {5e-7, 2.5e-6, 2e-5, 1e-11, 2e-5}},
        {"core32", trace_core32, {1e-6, 4e-6, 2e-5, 6e-7, 2e-5}},
    };
    return list;
}

ViewJudge::ViewJudge(FrameTables& tables, const Scene& scene) : scene_(scene) {
    auto tracer = reference::FrameTracer::make(scene_);
    const Status ready = tables.update(scene_);
    REQUIRE(tracer);
    REQUIRE(ready);
    tracer_.emplace(std::move(*tracer));
    input_ = tables.core_input();
    lapse_ = std::sqrt(tables.spacetime().lapse_squared(scene_.camera.r));
}

// Does the exact answer become the tested one within reach? Of two images of the disc, the nearer one counts.
bool ViewJudge::explained(const RayPixel& tested, const RayPixel& here, PixelPlace pixel, double reach_px) const {
    const auto off = [&](const RayPixel& other) { return std::hypot(other.u - tested.u, other.v - tested.v); };
    for (const double ring : kRings)
        for (int k = 0; k < kBearings; ++k) {
            const double bearing = 2 * M_PI * k / kBearings, reach = ring * reach_px;
            const RayPixel beside = tracer_->pixel(pixel.x + 0.5 + reach * std::cos(bearing),
                                                   pixel.y + 0.5 + reach * std::sin(bearing), false);
            if (!same_end(beside, tested)) continue;
            if (!same_end(here, tested) || off(beside) < 0.25 * off(here)) return true;
        }
    return false;
}

// Of the last pixel asked for: every core is judged by the same rays.
const ExactPixel& ViewJudge::exact_at(PixelPlace pixel) const {
    if (last_ && last_->first.x == pixel.x && last_->first.y == pixel.y) return last_->second;
    const ExactTrace trace = [this](const std::vector<std::array<double, 2>>& positions) {
        std::vector<RayPixel> pixels;
        for (const auto& position : positions) pixels.push_back(tracer_->pixel(position[0], position[1], false));
        return pixels;
    };
    return last_.emplace(pixel, exact_pixel(scene_.camera, trace, pixel.x, pixel.y)).second;
}

void ViewJudge::judge(const Core& core, PixelPlace pixel, const std::function<void(const Finding&)>& found) const {
    const ExactPixel& exact = exact_at(pixel);
    const RayPixel tested =
        core.trace(input_, pixel.x + 0.5 - 0.5 * scene_.camera.width, 0.5 * scene_.camera.height - (pixel.y + 0.5));
    const auto report = [&](const char* what, double error, double bound) {
        found({core.name, what, pixel, error == 0 ? 0 : error / bound});
    };
    if (!all_finite(tested)) return report("not finite", kInfinite, 1);
    ErrorAngles allowed = core.allowed;
    if (input_.spin) allowed.sky = allowed.place = allowed.edge = kStepped_rad;
    const double doppler = exact.here.g * lapse_, scale = exact.pixel_angle * std::min(1.0, doppler);
    const PixelErrors errors = pixel_errors(tested, exact);
    const double edge_px = allowed.edge / scale + kFateBand_px, place_bound = allowed.place / scale;
    const bool differs = errors.end == RayEnd::kDiffers;
    if (differs || errors.place_px > place_bound) {
        if (explained(tested, exact.here, pixel, edge_px)) return;
        return report(differs ? "end" : "place", differs ? kInfinite : errors.place_px, place_bound);
    }
    report("sky", errors.sky_px, allowed.sky / scale);
    report("swept angle", errors.angle_px, allowed.swept / scale);
    report("place", errors.place_px, place_bound);
    report("frequency", errors.g_px, allowed.frequency / scale);
}

}  // namespace nullscope::proof
