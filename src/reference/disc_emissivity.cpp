#include "reference/disc_emissivity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <tbb/parallel_for.h>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include "reference/bodies.h"
#include "scene/disc_emissivity.h"

namespace nullscope::reference {
namespace {

// From a break on, the integral of -q d(ln r) over the way there.
double log_power(const EmissivitySpec& spec, double r) {
    const double q[] = {spec.powers.x, spec.powers.y, spec.powers.z};
    double sum = -q[0] * std::log(r);
    for (std::size_t i = 0; i < spec.breaks.size(); ++i)
        sum -= (q[i + 1] - q[i]) * std::max(std::log(r / spec.breaks[i]), 0.0);
    return sum;
}

std::vector<double> of_table(const std::vector<EmissivityRow>& rows, const std::vector<double>& radii) {
    std::vector<double> values;
    std::size_t i = 0;
    for (const double r : radii) {
        while (i + 2 < rows.size() && r > rows[i + 1].r) ++i;
        const double x0 = std::log(rows[i].r), x1 = std::log(rows[i + 1].r), s = (std::log(r) - x0) / (x1 - x0);
        const bool within = r >= rows.front().r && r <= rows.back().r;
        values.push_back(within ? std::exp((1 - s) * std::log(rows[i].value) + s * std::log(rows[i + 1].value)) : 0.0);
    }
    return values;
}

// Where a ray from the lamp crosses the disc first, by its angle from the way inward.
class LampRays {
public:
    LampRays(const Metric& metric, double height) : metric_(metric), height_(height), none_({}, metric) {
        task_.bodies = &none_, task_.crossings = 1;
    }
    struct Met {
        double r, climb;  // of the light on its way from the lamp
    };
    std::optional<Met> crossing(double angle) const {
        RayQuery query;
        query.r = height_, query.theta = kOffAxis;
        query.n = {-std::cos(angle), std::sin(angle), 0};
        const auto ray = metric_.ray(query, task_);
        if (!ray) return {};
        const auto crossings = (*ray)->crossings(1);
        if (crossings.empty()) return {};
        return Met{crossings[0].r, -crossings[0].climb};  // traced against the light
    }
    Met met(double angle) const { return crossing(angle).value_or(Met{INFINITY, 0}); }
    // The angle of the ray to r, by halves: what crosses within or does not cross, falling in, has a smaller one.
    double angle_to(double r) const {
        double low = 0, high = M_PI;
        for (int i = 0; i < kHalves; ++i) {
            const double middle = 0.5 * (low + high);
            const auto found = crossing(middle);
            const bool outward = found ? found->r > r : leaves(middle);
            (outward ? high : low) = middle;
        }
        return 0.5 * (low + high);
    }

private:
    static constexpr double kOffAxis = 1e-7;  // rad: an axis has no azimuth
    static constexpr int kHalves = 44;
    bool leaves(double angle) const {
        RayQuery query;
        query.r = height_, query.theta = kOffAxis;
        query.n = {-std::cos(angle), std::sin(angle), 0};
        const auto ray = metric_.ray(query, task_);
        return ray && (*ray)->fate() == Fate::kEscaped;
    }
    const Metric& metric_;
    double height_;
    Bodies none_;
    RayTask task_;
};

// A function of the ray's angle between two ends, whose slopes there are of fourth order.
class Curve {
public:
    Curve(double first, double step, std::size_t count, const std::function<double(double)>& f) {
        std::vector<double> values(count);
        tbb::parallel_for(std::size_t{0}, count,
                          [&](std::size_t i) { values[i] = f(first + step * static_cast<double>(i)); });
        const auto slope = [&](double end, double h) {
            return (-25 * f(end) + 48 * f(end + h) - 36 * f(end + 2 * h) + 16 * f(end + 3 * h) - 3 * f(end + 4 * h)) /
                   (12 * h);
        };
        const double last = first + step * static_cast<double>(count - 1), within = step / 4;
        spline_ = {values.begin(), values.end(), first, step, slope(first, within), slope(last, -within)};
    }
    double operator()(double angle) const { return spline_(angle); }
    double slope(double angle) const { return spline_.prime(angle); }

private:
    boost::math::interpolators::cardinal_cubic_b_spline<double> spline_;
};

// Photons: sin(angle) d(angle) by the lamp's time, through the ring's part N sqrt(g_rr g_phiphi) dr of time and area.
std::vector<double> of_lamp(const Metric& metric, const DiscLight& of, const LampPost& lamp,
                            const std::vector<double>& radii) {
    constexpr std::size_t kRays = 400;
    const LampRays rays(metric, lamp.height);
    const double first = rays.angle_to(radii.front()), last = rays.angle_to(radii.back()),
                 step = (last - first) / (kRays - 1);
    const Curve place(first, step, kRays, [&](double angle) { return 1 / rays.met(angle).r; }),
        climbs(first, step, kRays, [&](double angle) { return rays.met(angle).climb; });
    const double lapse = std::sqrt(-metric.place(lamp.height, 0, 1).g_tt);
    std::vector<double> values;
    double angle = first;
    for (const double r : radii) {
        double low = first, high = last;
        for (int i = 0; i < 60; ++i) {
            angle = 0.5 * (low + high);
            (place(angle) < 1 / r ? high : low) = angle;
        }
        const EquatorialMetric g = metric.equator(r);
        const double ring = std::sqrt(g.lapse2() * g.g_rr * g.g_phiphi), slope = std::fabs(place.slope(angle)) * r * r;
        const double energy = lapse / of.g_infinity({r, 0, climbs(angle)});
        values.push_back(std::sin(angle) / slope / ring * lapse * std::pow(energy, lamp.index - 1));
    }
    return values;
}

}  // namespace

double largest_at_kinks(const EmissivitySpec& spec, double inner, double outer) {
    double most = 0;
    const auto within = [&](double r) { return r > inner && r < outer; };
    if (spec.by == Emissivity::kPowerLaw)
        for (const double r : spec.breaks)
            if (within(r)) most = std::max(most, std::exp(log_power(spec, r)));
    if (spec.by == Emissivity::kTable)
        if (const auto rows = load_emissivity(spec.file))
            for (const EmissivityRow& row : **rows)
                if (within(row.r)) most = std::max(most, row.value);
    return most;
}

std::vector<double> emissivity_of(const Metric& metric, const DiscLight& of, const EmissivitySpec& spec,
                                  const std::vector<double>& radii) {
    if (spec.by == Emissivity::kLamp) return of_lamp(metric, of, spec.lamp, radii);
    std::vector<double> values(radii.size(), 0.0);
    if (spec.by == Emissivity::kTable) {
        const auto rows = load_emissivity(spec.file);
        return rows ? of_table(**rows, radii) : values;
    }
    std::ranges::transform(radii, values.begin(), [&](double r) { return std::exp(log_power(spec, r)); });
    return values;
}

}  // namespace nullscope::reference
