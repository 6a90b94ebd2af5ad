#include "reference/kerr_fall.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "reference/kerr_between.h"
#include "reference/kerr_chart.h"

namespace nullscope::reference {
namespace {

constexpr double kFallStep = 0.02, kFallNear = 16;  // r_s/c, out to that radius; farther out both grow
constexpr double kFallenAbove = 1e-7;               // of the horizon: nearer it stays
constexpr double kFallRounding = 1e-12;             // likewise: no step begins nearer, some end there
constexpr int kStepsKept = 3;                       // a polynomial

KerrChart chart_of(const Metric& metric) {
    const double a = metric.a(), outer = metric.horizon_radius().value_or(1.0);
    return KerrChart{KerrHole(2 * a, 2 * std::sqrt(std::max(outer * (1 - outer) - a * a, 0.0)))};
}

// The way forward from t = 0: what it went through is kept.
class KerrFall {
public:
    using State = std::array<double, 6>;  // x, y, z of Kerr and Schild; momentum
    KerrFall(const KerrChart& chart, const State& start, double energy) : chart_(chart), energy_(energy) {
        stretches_.push_back({start, 0, nullptr});
    }
    Vec3 at(double t) {  // r, theta, phi
        const std::lock_guard lock(mutex_);
        while (!fallen_ && t >= end_of(stretches_.back())) extend();
        if (const Stretch& last = stretches_.back(); fallen_ && t >= last.from) {
            Vec3 there = place_of(last.begin);
            there.z += chart_.a / chart_.horizon_area(chart_.outer()) * (t - last.from);  // with the horizon
            return there;
        }
        const auto after = std::ranges::upper_bound(stretches_, t, {}, &Stretch::from);
        Stretch& stretch = *std::prev(after);
        if (!stretch.between) look_between(stretch);
        return place_of((*stretch.between)((t - stretch.from) / length_of(stretch)).value);
    }

private:
    using Between = HermiteNinth<6>;
    struct Stretch {
        State begin;
        double from;
        std::unique_ptr<const Between> between;
    };
    Vec3 place_of(const State& s) const {
        const Vec3 x{s[0], s[1], s[2]};
        const double r = chart_.radius(x);
        return {r, std::atan2(std::hypot(x.x, x.y) / std::hypot(r, chart_.a), x.z / r),
                std::atan2(x.y, x.x) - chart_.ahead(r)};
    }
    bool has_fallen(double r) const { return !(r > chart_.outer() * (1 + kFallenAbove)); }
    double radius_of(const State& s) const { return chart_.radius({s[0], s[1], s[2]}); }
    double length_of(const Stretch& stretch) const {
        return kStepsKept * kFallStep * std::max(1.0, radius_of(stretch.begin) / kFallNear);
    }
    double end_of(const Stretch& stretch) const { return stretch.from + length_of(stretch); }
    void extend() {
        const Stretch& last = stretches_.back();
        State s = last.begin;
        for (int i = 0; i < kStepsKept; ++i) s = after(s, length_of(last) / kStepsKept);
        if (has_fallen(radius_of(s)))
            fallen_ = true;
        else
            stretches_.push_back({s, end_of(last), nullptr});
    }
    void look_between(Stretch& stretch) const {
        std::array<Between::Known, Between::kPlaces> known;
        const double length = length_of(stretch);
        State next = stretch.begin;
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (i > 0) next = after(next, length * (Between::kAt[i] - Between::kAt[i - 1]));
            known[i].value = next;
            slope(next, known[i].slope);
            for (double& rate : known[i].slope) rate *= length;
        }
        stretch.between = std::make_unique<const Between>(known);
    }
    State after(State s, double h) const {
        boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
        stepper.do_step([this](const State& x, State& d, double) { slope(x, d); }, s, 0.0, h);
        return s;
    }
    // By Boyer and Lindquist's t = T - (r_* - r).
    void slope(const State& s, State& d) const {
        d = {};
        const Vec3 x{s[0], s[1], s[2]}, p{s[3], s[4], s[5]};
        const double r = chart_.radius(x);
        if (!(r > chart_.outer() * (1 + kFallRounding))) return;
        const KerrChart::Pull pull = chart_.pull(energy_, x, p);
        const Vec3 way = p + pull.drift;
        const double time = energy_ + pull.delay - chart_.tortoise_slope(r) * chart_.rising(x, way);
        d = {way.x / time, way.y / time, way.z / time, pull.force.x / time, pull.force.y / time, pull.force.z / time};
    }
    KerrChart chart_;
    double energy_;
    std::vector<Stretch> stretches_;
    bool fallen_ = false;  // within the last of them; from its begin on r stays
    std::mutex mutex_;
};

// sense 1: forward; -1: the mirrored way, on which the radial and polar velocities are the opposite ones.
std::shared_ptr<KerrFall> fall_of(const Metric& metric, double r, double theta, double phi, Vec3 v, double sense) {
    const KerrChart chart = chart_of(metric);
    const double sine = std::sin(theta), cosine = std::cos(theta), gamma = 1 / std::sqrt(1 - dot(v, v));
    const PlaceMetric g = metric.place(r, sine, cosine);
    // e_phi of one at rest: d/dphi - (g_tphi/g_tt) d/dt, over its length.
    const double across = std::sqrt(g.g_phiphi - g.g_tphi * g.g_tphi / g.g_tt),
                 u_phi = sine > 0 ? gamma * v.z / across : 0,
                 u_t = gamma / std::sqrt(-g.g_tt) - u_phi * g.g_tphi / g.g_tt,
                 u_r = sense * gamma * v.x / std::sqrt(g.g_rr),
                 u_theta = sense * gamma * v.y / std::sqrt(g.g_thetatheta);
    const double wide = std::hypot(r, chart.a), azimuth = phi + chart.ahead(r), c = std::cos(azimuth),
                 s = std::sin(azimuth);
    const double rho = wide * sine, rho_rate = u_r * r / wide * sine + wide * cosine * u_theta,
                 turn = u_phi + chart.ahead_slope(r) * u_r;
    const Vec3 x{rho * c, rho * s, r * cosine},
        u{rho_rate * c - rho * s * turn, rho_rate * s + rho * c * turn, u_r * cosine - r * sine * u_theta};
    const double time = u_t + chart.tortoise_slope(r) * u_r, r2 = r * r, sum = r2 * r2 + chart.a * chart.a * x.z * x.z,
                 twice_h = chart.twice_mass(r) * r2 * r / sum, area = r2 + chart.a * chart.a;
    const Vec3 l{(r * x.x + chart.a * x.y) / area, (r * x.y - chart.a * x.x) / area, x.z / r};
    const double along = time + dot(l, u);
    const Vec3 p = u + twice_h * along * l;
    return std::make_shared<KerrFall>(chart, KerrFall::State{x.x, x.y, x.z, p.x, p.y, p.z}, time - twice_h * along);
}

}  // namespace

std::function<Vec3(double t)> kerr_fall(const Metric& metric, Vec3 position, Vec3 velocity) {
    const double r = length(position), theta = std::atan2(std::hypot(position.x, position.y), position.z);
    double phi = std::atan2(position.y, position.x);
    if (theta == 0 ||
        position.x * position.x + position.y * position.y == 0) {  // on the axis all that is across is southward
        phi += std::atan2(velocity.z, velocity.y);
        velocity = {velocity.x, std::hypot(velocity.y, velocity.z), 0};
    }
    const auto forward = fall_of(metric, r, theta, phi, velocity, 1),
               back = fall_of(metric, r, theta, phi, velocity, -1);
    return [=](double t) {
        const Vec3 at = t < 0 ? back->at(-t) : forward->at(t);
        const double azimuth = t < 0 ? 2 * phi - at.z : at.z;
        return at.x * Vec3{std::sin(at.y) * std::cos(azimuth), std::sin(at.y) * std::sin(azimuth), std::cos(at.y)};
    };
}

}  // namespace nullscope::reference
