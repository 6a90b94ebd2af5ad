#include "reference/kerr_ray.h"

#include <algorithm>
#include <array>
#include <cmath>

// Boost copies the empty scratch space of a stepper.
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "reference/schwarzschild_orbit.h"

namespace nullscope::reference {
namespace {

using State = std::array<double, 6>;   // x, y, z, p_x, p_y, p_z
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State>;

// Of each step, absolute and relative; the steps' errors add up to some ten times this.
constexpr double kStepTolerance = 1e-14;
// A ray has reached the sky where what is left of its bending, M b / R^2, is below rounding.
constexpr double kSky = 1e9;
constexpr int kMostSteps = 20000;        // near-critical rays take some hundred
constexpr double kOnEquator = 1e-12;     // |cos theta| below which a camera is in the plane (docs/ray-data.md)
constexpr double kStaysThere = 5e-11;    // and the root of Carter's constant over E, r_s, below which its ray stays in it

// g = eta + 2 H l l with l = (1, lx, ly, lz), regular where matter falls in.
struct Chart {
    double a;

    double radius(const State& s) const {
        const double flat = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] - a * a, az = a * s[2], root = std::hypot(flat, 2 * az);
        // The larger root of r^4 - flat r^2 - a^2 z^2 = 0, without a difference.
        return std::sqrt(flat > 0 ? 0.5 * (flat + root) : 2 * az * az / (root - flat));
    }

    // dx/dlambda and dp/dlambda of H = (eta^{mu nu} p p - 2 H (l p)^2)/2 with p_t = -energy.
    void slope(double energy, const State& s, State& d) const {
        const double x = s[0], y = s[1], z = s[2], r = radius(s), r2 = r * r, across = r2 + a * a;
        const double sum = r2 * r2 + a * a * z * z, h = 0.5 * r2 * r / sum;
        const double lx = (r * x + a * y) / across, ly = (r * y - a * x) / across, lz = z / r;
        const double lp = energy + lx * s[3] + ly * s[4] + lz * s[5];
        d[0] = s[3] - 2 * h * lp * lx;
        d[1] = s[4] - 2 * h * lp * ly;
        d[2] = s[5] - 2 * h * lp * lz;
        const std::array<double, 3> dr{x * r2 * r / sum, y * r2 * r / sum, z * r * across / sum};
        for (std::size_t i = 0; i < 3; ++i) {
            const double dsum = 4 * r2 * r * dr[i] + (i == 2 ? 2 * a * a * z : 0.0);
            const double dh = h * (3 * dr[i] / r - dsum / sum);
            const double dlx = ((dr[i] * x + (i == 0 ? r : i == 1 ? a : 0.0)) - lx * 2 * r * dr[i]) / across;
            const double dly = ((dr[i] * y + (i == 1 ? r : i == 0 ? -a : 0.0)) - ly * 2 * r * dr[i]) / across;
            const double dlz = ((i == 2 ? 1.0 : 0.0) - lz * dr[i]) / r;
            d[3 + i] = dh * lp * lp + 2 * h * lp * (dlx * s[3] + dly * s[4] + dlz * s[5]);
        }
    }

    // What the azimuth of x + iy = (r + ia) sin(theta) e^{i phi~} is ahead of Boyer and Lindquist's, which it meets at infinity.
    double ahead(double r, double root) const {
        const double inner = 0.5 * (1 - root);
        return std::atan2(a, r) + (root > 0 ? a / root * std::log1p(-root / (r - inner)) : -a / (r - 0.5));
    }
};

// Of the azimuth along a step that begins at azimuth `at`, in (-pi, pi]; where that is near half a turn the motion's own sense decides.
double turned(double at, const State& from, const State& to, const State& slope) {
    if (from[0] == 0 && from[1] == 0) return std::remainder(std::atan2(to[1], to[0]) - at, 2 * M_PI);   // from the axis
    double turn = std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    const double sense = from[0] * slope[1] - from[1] * slope[0];
    if (std::abs(turn) > 2.5 && turn * sense < 0) turn += sense > 0 ? 2 * M_PI : -2 * M_PI;
    return turn;
}

class Path {
public:
    Path(double spin, const KerrStart& start);
    KerrRay trace(int most_crossings);

private:
    void add_crossing(const State& before, double taken, KerrRay& ray) const;
    State stepped(const State& from, double length) const {
        State to = from;
        Stepper().do_step([this](const State& s, State& d, double) { chart_.slope(energy_, s, d); }, to, 0.0, length);
        return to;
    }
    double boyer_lindquist(double chart_azimuth, double r) const { return phi_ - (chart_azimuth - chart_.ahead(r, root_)); }

    Chart chart_;
    double root_, outer_, phi_, energy_, momentum_, scale_ = 1;
    double azimuth_;   // in the chart, windings kept
    bool stays_ = false;
    State state_{};
};

Path::Path(double spin, const KerrStart& start)
    : chart_{0.5 * spin}, root_(std::sqrt((1 - spin) * (1 + spin))), outer_(0.5 * (1 + root_)), phi_(start.phi) {
    const double a = chart_.a, r = start.r, sine = std::sin(start.theta), cosine = std::cos(start.theta);
    const double sigma = r * r + a * a * cosine * cosine, across = r * r + a * a, delta = (r - outer_) * (r - 0.5 * (1 - root_));
    const double area = across * sigma + a * a * r * sine * sine;   // (r^2 + a^2)^2 - Delta a^2 sin^2
    const double frequency = length(start.look);
    const double lapse = std::sqrt(delta * sigma / area), drag = a * r / area, girth = std::sqrt(area / sigma);
    const double l_over_sine = -girth * start.look.z;   // the photon runs against the look direction
    momentum_ = l_over_sine * sine;
    energy_ = lapse * frequency + drag * momentum_;
    // The mirrored photon: energy and L_z of the real one, r and theta towards the look direction.
    const double p_theta = std::sqrt(sigma) * start.look.y, y = std::sqrt(sigma * delta) * start.look.x;   // Delta p_r
    const double x = energy_ * across - a * momentum_, w = l_over_sine - a * energy_ * sine;
    const double carter = p_theta * p_theta + w * w;
    // p_r of the chart: (x + y)/Delta - E, with x^2 - y^2 = Delta K.
    const double p_r = (y < 0 ? carter / (x - y) : (x + y) / delta) - energy_;
    // To Cartesian components: x + iy = (r + ia) sin(theta) e^{i psi}, psi = 0 at the camera but for what the chart is ahead.
    const double psi = chart_.ahead(r, root_) - std::atan2(a, r), c = std::cos(psi), s = std::sin(psi);
    azimuth_ = chart_.ahead(r, root_);
    const double height = std::abs(cosine) < kOnEquator ? 0.0 : cosine;
    state_[0] = (r * c - a * s) * sine;
    state_[1] = (r * s + a * c) * sine;
    state_[2] = r * height;
    // Components along d(place)/dr, d(place)/dtheta and the unit vector of psi, an oblique frame on which p is known.
    const Vec3 by_r{c * sine, s * sine, cosine}, by_theta{(r * c - a * s) * cosine, (r * s + a * c) * cosine, -r * sine};
    const Vec3 by_psi{-(r * s + a * c), r * c - a * s, 0};   // over sine
    const Vec3 n0 = cross(by_theta, by_psi), n1 = cross(by_psi, by_r), n2 = cross(by_r, by_theta);
    const double volume = dot(by_r, n0);
    const Vec3 p = (p_r * n0 + p_theta * n1 + l_over_sine * n2) / volume;
    state_[3] = p.x, state_[4] = p.y, state_[5] = p.z;
    scale_ = std::max(1.0, r);
    stays_ = height == 0.0 && std::abs(p_theta) < kStaysThere * std::abs(energy_);
}

// The zero of z within the step: Newton's steps on its length, each taken whole from where the step began.
void Path::add_crossing(const State& before, double taken, KerrRay& ray) const {
    double low = 0, high = taken, at = 0;
    State there = before, d{};
    for (int i = 0; i < 60; ++i) {
        chart_.slope(energy_, there, d);
        double next = at - there[2] / d[2];
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double move = std::abs(next - at);
        at = next;
        there = stepped(before, at);
        ((there[2] > 0) == (before[2] > 0) ? low : high) = at;
        if (move <= 1e-15 * std::abs(at) || there[2] == 0) break;
    }
    chart_.slope(energy_, there, d);
    const double r = chart_.radius(there);
    if (!(r > outer_)) return;
    const double phi = boyer_lindquist(azimuth_ + turned(azimuth_, before, there, d), r);
    // Sigma dr/dlambda = Delta p_r of the mirror image; the photon's own has the other sign. In the plane r dr = x dx + y dy.
    const double climbing = (there[0] * d[0] + there[1] * d[1]) / r, delta = (r - outer_) * (r - 0.5 * (1 - root_));
    ray.crossings.push_back({r, phi, -climbing * r * r / (delta * energy_)});
}

KerrRay Path::trace(int most_crossings) {
    using boost::numeric::odeint::controlled_step_result;
    KerrRay ray;
    ray.energy = energy_;
    ray.l_z = momentum_ / energy_;
    auto stepper = boost::numeric::odeint::make_controlled(kStepTolerance, kStepTolerance, Stepper());
    const auto system = [this](const State& s, State& d, double) { chart_.slope(energy_, s, d); };
    const double sky = std::max(kSky, 1e6 * scale_);
    double lambda = 0, length = 0.01 * scale_;
    for (int i = 0; i < kMostSteps; ++i) {
        const State before = state_;
        const double from = lambda;
        if (stepper.try_step(system, state_, lambda, length) == controlled_step_result::fail) continue;
        State slope{};
        chart_.slope(energy_, before, slope);
        const bool crossed = before[2] != 0 && (before[2] > 0) != (state_[2] > 0) && !stays_;
        if (crossed && static_cast<int>(ray.crossings.size()) < most_crossings) add_crossing(before, lambda - from, ray);
        azimuth_ += turned(azimuth_, before, state_, slope);
        const double r = chart_.radius(state_);
        if (r <= outer_) {
            ray.fate = Fate::kCaptured;
            return ray;
        }
        if (r < sky) continue;
        ray.fate = Fate::kEscaped;
        chart_.slope(energy_, state_, slope);   // the motion's direction, nearer to the sky's than the place's
        const double place = std::atan2(state_[1], state_[0]), motion = std::atan2(slope[1], slope[0]);
        ray.phi_inf = phi_ - (azimuth_ + std::remainder(motion - place, 2 * M_PI));
        const double flat = std::hypot(slope[0], slope[1]), all = std::hypot(flat, slope[2]);
        ray.sky = {flat / all * std::cos(ray.phi_inf), flat / all * std::sin(ray.phi_inf), slope[2] / all};
        return ray;
    }
    ray.fate = Fate::kCaptured;   // still winding: closer to the critical ray than a double can tell
    return ray;
}

}  // namespace

KerrRay trace_kerr(double spin, const KerrStart& start, int most_crossings) { return Path(spin, start).trace(most_crossings); }

namespace {

class KerrMetric final : public OrbitMetric {
public:
    explicit KerrMetric(double spin) : spin_(spin) {}
    double spin() const override { return spin_; }
    std::optional<double> horizon_radius() const override { return 0.5 * (1 + std::sqrt((1 - spin_) * (1 + spin_))); }
    EquatorialMetric equator(double r) const override {
        const double a = 0.5 * spin_;
        return {-(1 - 1 / r), -a / r, r * r + a * a + a * a / r, r * r / (r * r - r + a * a)};
    }
    double lapse(double r) const override {
        const EquatorialMetric g = equator(r);
        return std::sqrt(g.g_tphi * g.g_tphi / g.g_phiphi - g.g_tt);
    }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay&) const override {
        return bad_input("no ray of a spinning hole is given by q, zeta0 and s; allowed: r, theta, phi, n_r, n_theta, n_phi");
    }
    std::unique_ptr<Orbit> from_static(const LocalRay&) const override { return nullptr; }
    RainOrbit from_rain(const LocalRay&) const override { return {nullptr, kNotANumber}; }

private:
    double spin_;
};

}  // namespace

std::unique_ptr<OrbitMetric> make_kerr_metric(const SpacetimeSpec& spec) {
    const auto found = spec.parameters.find("spin");
    const double spin = found == spec.parameters.end() ? 0.9 : found->second;
    if (spin == 0) return make_schwarzschild_orbits(spec);
    return std::make_unique<KerrMetric>(spin);
}

}  // namespace nullscope::reference
