#include "reference/light_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace nullscope::reference {
namespace {

// Rays are equally far apart in the logarithm of what their angle is off that of the last one: light time is smooth in it, with its
// singularity where a ray has left for the sky, of places within a third of the camera's radius 0.2 away. Off by less, rounded angles say
// less than the clock does: a rounding of the last angle, 1e-16 of it, is 1e-9 of what it is off, and the light time grows by some r_s where
// that falls to a part.
constexpr double kRaysApart = 0.005, kLeastOff = 1e-7, kLeastOff_rad = 1e-9;  // of the last angle; where that is 0
constexpr std::size_t kNodes = 10;
constexpr double kTimeError = 1e-11;  // of the light time: what two fewer rays change

double last_escaping(const LightTimes::RayAt& ray_at) {
    double sky = 0.5 * M_PI, lost = 0;
    const auto escapes = [&](double inward) { return ray_at(inward).orbit->fate() == Fate::kEscaped; };
    if (!escapes(sky)) lost = std::exchange(sky, M_PI - 1e-9);
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (sky + lost);
        if (middle >= sky || middle <= lost) break;
        (escapes(middle) ? sky : lost) = middle;
    }
    return sky;
}

// The polynomial through these places and values.
double between(std::span<const double> places, std::span<const double> values, double place) {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (place == places[i]) return values[i];
        double weight = place - places[i];
        for (std::size_t k = 0; k < places.size(); ++k)
            if (k != i) weight *= places[i] - places[k];
        sum += values[i] / weight, weights += 1 / weight;
    }
    return sum / weights;
}

}  // namespace

LightTimes::LightTimes(const OrbitMetric& metric, RayAt ray_at, double camera_r, bool falls)
    : metric_(metric),
      ray_at_(std::move(ray_at)),
      camera_r_(camera_r),
      falls_(falls),
      last_(last_escaping(ray_at_)),
      least_(std::max(kLeastOff * last_, kLeastOff_rad)),
      grid_(static_cast<std::size_t>(place_of(last_ + least_)) + 2 * kNodes) {}

double LightTimes::place_of(double inward) const { return -std::log((inward - last_) / (M_PI - last_)) / kRaysApart; }

double LightTimes::delay(std::size_t i, double angle) const {
    Known& known = grid_[i];
    std::call_once(known.made, [&] {
        const double inward = last_ + (M_PI - last_) * std::exp(-kRaysApart * static_cast<double>(i));
        known.ray = ray_at_(inward), known.place = place_of(inward);
        known.clock.emplace(metric_, *known.ray.orbit, known.ray.q, camera_r_, falls_);
    });
    const std::lock_guard lock(known.mutex);
    return angle < known.ray.orbit->angle() ? known.clock->delay(angle) : kNotANumber;
}

std::optional<double> LightTimes::operator()(double inward, double angle) const {
    if (!(inward < M_PI && inward - last_ > least_)) return std::nullopt;
    const double place = place_of(inward);
    const auto first =
        static_cast<std::size_t>(std::max(std::floor(place) - 0.5 * kNodes + 1, 1.0));  // 0: along the radius
    std::array<double, kNodes> places{}, times{};
    for (std::size_t i = 0; i < kNodes; ++i) {
        times[i] = delay(first + i, angle);
        places[i] = grid_[first + i].place;
    }
    const double time = between(places, times, place);
    const double fewer =
        between(std::span(places).subspan(1, kNodes - 2), std::span(times).subspan(1, kNodes - 2), place);
    if (!(std::abs(time - fewer) <= kTimeError * std::abs(time))) return std::nullopt;
    return time;
}

}  // namespace nullscope::reference
