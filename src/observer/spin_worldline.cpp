#include "observer/spin_worldline.h"

#include <algorithm>
#include <cmath>

#include "numeric/dormand_prince.h"
#include "observer/lorentz.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/spin_frame.h"
#include "spacetime/tortoise.h"

namespace nullscope {
namespace {

// Of a step, relative to what it acts on, at least 1: 1e-11 over the orbits of a film, but for rounding.
constexpr double kSpinTolerance = 5e-15;
// Of the way between the horizons: who goes round fast enough nears one that v does not reach, its components without bound.
constexpr double kShortOfInner = 0.05;
constexpr double kNoSpin = 1e-11;  // c: see worldline.cpp
constexpr std::size_t kMostSpinNodes = 1000000;

using Vec4 = std::array<double, 4>;  // t, x, y, z

// The metric at a place, and its derivatives along x, y and z.
struct KerrSchildField {
    double r, f;
    std::array<double, 4> l;
    std::array<double, 3> df;
    std::array<std::array<double, 3>, 4> dl;  // dl[mu][k]

    KerrSchildField(const AxialMetric& metric, double x, double y, double z) {
        const double a = metric.a(), c = metric.charge2();
        const double flat = x * x + y * y + z * z - a * a, root = std::hypot(flat, 2 * a * z);
        r = std::sqrt(flat > 0 ? 0.5 * (flat + root) : 2 * a * a * z * z / (root - flat));
        const double r2 = r * r, across = r2 + a * a, sum = r2 * r2 + a * a * z * z;
        f = (r - c) * r2 / sum;
        l = {1, (r * x + a * y) / across, (r * y - a * x) / across, z / r};
        dl[0] = {0, 0, 0};
        const std::array<double, 3> place{x, y, z};
        for (std::size_t k = 0; k < 3; ++k) {
            const double dr = k == 2 ? z * r * across / sum : place[k] * r2 * r / sum;
            df[k] = ((3 * r - 2 * c) * r * dr - f * (4 * r2 * r * dr + (k == 2 ? 2 * a * a * z : 0))) / sum;
            dl[1][k] = (dr * x + (k == 0 ? r : k == 1 ? a : 0) - l[1] * 2 * r * dr) / across;
            dl[2][k] = (dr * y + (k == 1 ? r : k == 0 ? -a : 0) - l[2] * 2 * r * dr) / across;
            dl[3][k] = ((k == 2 ? 1 : 0) - l[3] * dr) / r;
        }
    }

    double along(const Vec4& v) const { return l[0] * v[0] + l[1] * v[1] + l[2] * v[2] + l[3] * v[3]; }
    double product(const Vec4& a, const Vec4& b) const {
        return -a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + f * along(a) * along(b);
    }
    // -Gamma(u, v): with g_{ab,k} = f_k l_a l_b + f (l_{a,k} l_b + l_a l_{b,k}), down, then up by eta - f l l.
    Vec4 carried(const Vec4& u, const Vec4& v) const {
        const double lu = along(u), lv = along(v);
        double fu = 0, fv = 0, across = 0, back = 0;  // f_k u^k, f_k v^k, l_{a,k} u^k v^a and the other way round
        Vec4 du{}, dv{};
        for (std::size_t k = 0; k < 3; ++k) {
            fu += df[k] * u[k + 1], fv += df[k] * v[k + 1];
            for (std::size_t m = 1; m < 4; ++m) du[m] += dl[m][k] * u[k + 1], dv[m] += dl[m][k] * v[k + 1];
        }
        for (std::size_t m = 1; m < 4; ++m) across += du[m] * v[m], back += dv[m] * u[m];
        Vec4 down{};
        for (std::size_t m = 0; m < 4; ++m) {
            double gradient = 0;  // of g(u, v)
            if (m > 0) {
                double mu = 0, mv = 0;
                for (std::size_t n = 1; n < 4; ++n) mu += dl[n][m - 1] * u[n], mv += dl[n][m - 1] * v[n];
                gradient = df[m - 1] * lu * lv + f * (mu * lv + mv * lu);
            }
            down[m] = 0.5 * (fu * l[m] * lv + f * (du[m] * lv + l[m] * across) + fv * l[m] * lu +
                             f * (dv[m] * lu + l[m] * back) - gradient);
        }
        const double lw = -down[0] + l[1] * down[1] + l[2] * down[2] + l[3] * down[3];
        return {down[0] - f * lw, -down[1] + f * l[1] * lw, -down[2] + f * l[2] * lw, -down[3] + f * l[3] * lw};
    }
};

struct Place {
    double r, theta, phi;
};
Place place_of(const AxialMetric& metric, double x, double y, double z) {
    const KerrSchildField field(metric, x, y, z);
    const double a = metric.a();
    return {field.r, std::atan2(std::hypot(x, y) / std::sqrt(field.r * field.r + a * a), z / field.r),
            std::atan2(y, x) - std::atan2(a, field.r)};
}

// From components along d_v, d_r, d_theta and d_phi~/sin(theta).
Vec4 cartesian(double a, const Place& p, const Vec4& hat) {
    const double st = std::sin(p.theta), ct = std::cos(p.theta), c = std::cos(p.phi), s = std::sin(p.phi);
    const double x = p.r * c - a * s, y = p.r * s + a * c;  // over sin(theta)
    return {hat[0] - hat[1], c * st * hat[1] + x * ct * hat[2] - y * hat[3],
            s * st * hat[1] + y * ct * hat[2] + x * hat[3], ct * hat[1] - p.r * st * hat[2]};
}

template <class State>
Vec4 state_vector(const State& state, std::size_t i) {
    return {state[3 + 4 * i], state[4 + 4 * i], state[5 + 4 * i], state[6 + 4 * i]};
}

template <class State>
State spin_slope(const AxialMetric& metric, const State& state) {
    const KerrSchildField field(metric, state[0], state[1], state[2]);
    const Vec4 u = state_vector(state, 0);
    State d{};
    d[0] = u[1], d[1] = u[2], d[2] = u[3], d.back() = u[0];
    for (std::size_t i = 0; 6 + 4 * i < state.size(); ++i) {
        const Vec4 by = field.carried(u, state_vector(state, i));
        std::copy(by.begin(), by.end(), d.begin() + 3 + 4 * static_cast<std::ptrdiff_t>(i));
    }
    return d;
}

}  // namespace

const AxialMetric& SpinWorldline::metric() const { return *spacetime_->axial(); }

Result<SpinWorldline> SpinWorldline::make(std::shared_ptr<const Spacetime> spacetime, const CameraSpec& start,
                                          double duration) {
    TRY(tetrad, ingoing_hat_pair(*spacetime, start));
    SpinWorldline line;
    line.spacetime_ = std::move(spacetime);
    line.start_ = start;
    const AxialMetric& metric = line.metric();
    const double a = metric.a();
    const Place place{start.r, start.theta, start.phi + (falls(start) ? 0.0 : metric.azimuth_ahead(start.r))};
    const double st = std::sin(place.theta), c = std::cos(place.phi), s = std::sin(place.phi);
    State state{(place.r * c - a * s) * st, (place.r * s + a * c) * st, place.r * std::cos(place.theta)};
    for (std::size_t i = 0; i < kVectors; ++i) {
        const Vec4 v = cartesian(a, place, tetrad->high[i]);
        std::copy(v.begin(), v.end(), state.begin() + 3 + 4 * static_cast<std::ptrdiff_t>(i));
    }
    line.ahead_ = falls(start) ? 0.0 : time_ahead(metric, start.r);
    line.nodes_.push_back({0, state, 0});
    line.run(duration);
    return line;
}

void SpinWorldline::run(double duration) {
    const AxialMetric& metric = this->metric();
    const double outer = metric.outer_horizon(), inner = metric.inner_horizon(),
                 low = inner + kShortOfInner * (outer - inner);
    const auto slope = [&](const State& s) { return spin_slope(metric, s); };
    const auto azimuth_of = [&](const State& s) { return place_of(metric, s[0], s[1], s[2]).phi; };
    const auto radius_of = [&](const State& s) { return KerrSchildField(metric, s[0], s[1], s[2]).r; };
    double h = 1e-3 * std::min(duration, start_.r);
    while (nodes_.size() < kMostSpinNodes && nodes_.back().tau < duration && !ends_) {
        const Node now = nodes_.back();
        h = std::min(h, duration - now.tau);
        State wrong{};
        const State next = dormand_prince(now.state, h, slope, wrong);
        double error = 0;
        for (std::size_t n = 0; n < kSize; ++n)
            error = std::max(error, std::fabs(wrong[n]) / std::max(std::fabs(now.state[n]), 1.0) / kSpinTolerance);
        for (const double x : next)
            if (!std::isfinite(x)) error = INFINITY;
        // The length of a step that ends at this radius, by halving it.
        const auto time_at = [&](double r) {
            double before = 0, after = h;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (before + after);
                (radius_of(dormand_prince(now.state, middle, slope, wrong)) > r ? before : after) = middle;
            }
            return before;
        };
        const auto add = [&](double length, const State& end) {
            nodes_.push_back({now.tau + length, end,
                              now.azimuth + std::remainder(azimuth_of(end) - azimuth_of(now.state), 2 * M_PI)});
        };
        if (error <= 1 && radius_of(next) <= low) {
            const double rest = time_at(low);
            add(rest, dormand_prince(now.state, rest, slope, wrong));
            ends_ = true;
        } else if (error <= 1) {
            if (!horizon_time_ && radius_of(next) <= outer && radius_of(now.state) > outer)
                horizon_time_ = now.tau + time_at(outer);
            add(h, next);
        }
        h *= next_step_factor(error);
    }
}

SpinWorldline::Node SpinWorldline::node_at(double tau) const {
    const double when = std::clamp(tau, 0.0, last());
    if (nodes_.size() == 1) return nodes_.front();
    const auto after =
        std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, when, [](double t, const Node& n) { return t < n.tau; });
    const Node& before = *(after - 1);
    const AxialMetric& metric = this->metric();
    State wrong{};
    const State there = dormand_prince(
        before.state, when - before.tau, [&](const State& s) { return spin_slope(metric, s); }, wrong);
    const double turned = place_of(metric, there[0], there[1], there[2]).phi -
                          place_of(metric, before.state[0], before.state[1], before.state[2]).phi;
    return {when, there, before.azimuth + std::remainder(turned, 2 * M_PI)};
}

double SpinWorldline::clock(double tau) const { return ahead_ + node_at(tau).state[kClock]; }

double SpinWorldline::azimuth(double tau) const { return node_at(tau).azimuth; }

SpinWorldline::Constants SpinWorldline::constants(double tau) const {
    const State s = node_at(tau).state;
    const AxialMetric& metric = this->metric();
    const double a = metric.a();
    const KerrSchildField field(metric, s[0], s[1], s[2]);
    const Vec4 u = state_vector(s, 0);
    const Place place = place_of(metric, s[0], s[1], s[2]);
    const double st = std::sin(place.theta), energy = -field.product({1, 0, 0, 0}, u),
                 across = field.product(cartesian(a, place, {0, 0, 0, 1}), u);
    const double p_theta = field.product(cartesian(a, place, {0, 0, 1, 0}), u), w = across - a * energy * st;
    return {energy, across * st, p_theta * p_theta + w * w + a * a * std::pow(std::cos(place.theta), 2),
            field.product(u, u)};
}

CameraSpec SpinWorldline::at(double tau) const {
    const State s = node_at(tau).state;
    const AxialMetric& metric = this->metric();
    const double a = metric.a();
    const KerrSchildField field(metric, s[0], s[1], s[2]);
    const Place place = place_of(metric, s[0], s[1], s[2]);
    CameraSpec camera = start_;
    camera.observer = ObserverKind::kRain;
    camera.velocity = {};
    camera.r = place.r, camera.theta = place.theta, camera.phi = std::remainder(place.phi, 2 * M_PI);
    camera.yaw = camera.pitch = camera.roll = 0;  // right e_phi, up -e_theta, backward e_r
    const auto frame = ingoing_hat_pair(*spacetime_, camera);
    if (!frame) return start_;  // a worldline ends where there is none
    Vec4 axes[4];
    for (std::size_t i = 0; i < 4; ++i) axes[i] = cartesian(a, place, frame->high[i]);
    Lorentz tetrad{};
    for (std::size_t i = 0; i < kVectors; ++i) {
        const Vec4 v = state_vector(s, i);
        tetrad[0][i] = -field.product(axes[0], v);
        tetrad[1][i] = field.product(axes[3], v), tetrad[2][i] = -field.product(axes[2], v),
        tetrad[3][i] = field.product(axes[1], v);
    }
    const BoostAndTurn parts = split(tetrad);
    camera.velocity = length(parts.velocity) > kNoSpin ? parts.velocity : Vec3{};
    set_axes(camera, parts.turn);
    return camera;
}

}  // namespace nullscope
