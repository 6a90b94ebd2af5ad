#include "reference/ball_way.h"

#include <algorithm>
#include <cmath>

#include "expr/formula.h"

namespace nullscope::reference {
namespace {

double lapse2(const OrbitMetric& metric, double r) {
    const double lapse = metric.lapse(r);
    return lapse * lapse;
}

double slope_of(const OrbitMetric& metric, double r) {   // of A; eighth order
    const double h = std::min(0.01 * r, 0.1 * (r - metric.horizon_radius().value_or(0.0)));   // all of it outside
    const auto d = [&](int n) { return lapse2(metric, r + n * h) - lapse2(metric, r - n * h); };
    return (d(1) * 4.0 / 5 - d(2) / 5 + d(3) * 4.0 / 105 - d(4) / 280) / h;
}

}  // namespace

double kepler_rate(const OrbitMetric& metric, double r) { return std::sqrt(std::fmax(slope_of(metric, r), 0) / (2 * r)); }

std::function<Vec3(double t)> ball_way(const OrbitMetric& metric, const BallSpec& ball) {
    const Vec3 start = ball.position;
    const double r = length(start), azimuth = std::atan2(start.y, start.x);
    const Vec3 e_r = start / r, e_phi{-std::sin(azimuth), std::cos(azimuth), 0};
    const auto turned = [=](Vec3 onward, double radius, double phi) { return radius * (std::cos(phi) * e_r + std::sin(phi) * onward); };
    switch (ball.motion) {
        case BallMotion::kStill: break;
        case BallMotion::kOrbit: return [=, omega = kepler_rate(metric, r)](double t) { return turned(e_phi, r, omega * t); };
        case BallMotion::kGeodesic: break;   // refused by FrameTracer::make
        case BallMotion::kPath: {
            const auto x = expr::Formula::parse(ball.x, {"t"}), y = expr::Formula::parse(ball.y, {"t"}), z = expr::Formula::parse(ball.z, {"t"});
            if (!x || !y || !z) break;
            return [x = *x, y = *y, z = *z](double t) {
                const double at[] = {t};
                return Vec3{x.value(at), y.value(at), z.value(at)};
            };
        }
    }
    return [start](double) { return start; };
}

}  // namespace nullscope::reference
