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

using State = std::array<double, 7>;   // x, y, z, p_x, p_y, p_z, and t less what grows with the distance: t - sense sqrt(x^2 + y^2 + z^2)
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State>;

// Of each step, absolute and relative; the steps' errors add up to some ten times this.
constexpr double kStepTolerance = 1e-14;
constexpr double kClockUnit = 1e-4;   // what the time is kept in: its steps are good to 1e-10 r_s/c, and do not ask for shorter ones
// A ray has reached the sky where what is left of its bending, M b / R^2, is below rounding.
constexpr double kSky = 1e9;
// Where T is read, in camera radii: further on it loses what rounding makes of |dx/dlambda| = 1, nearer M b^2/R^2.
constexpr double kFarForTime = 1e4;
constexpr int kMostSteps = 20000;        // near-critical rays take some hundred
constexpr double kAboveHorizon = 1e-9;   // of its radius: how near to it a ray is shown; nearer, rounding turns the azimuth by 1e-7 rad and more
constexpr int kHalvings = 40;            // of a step through the horizon: beyond them is rounding
constexpr double kOnEquator = 1e-12;     // |cos theta| below which a camera is in the plane (docs/ray-data.md)
constexpr double kStaysThere = 5e-11;    // and the root of Carter's constant over E, r_s, below which its ray stays in it

// g = eta + 2 H l l with l = (1, lx, ly, lz), regular where matter falls in.
struct Chart {
    double a;
    double sense = 1;   // of Path

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
        d[6] = kClockUnit * (energy + 2 * h * lp - sense * (x * d[0] + y * d[1] + z * d[2]) / std::sqrt(x * x + y * y + z * z));
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

// r_* - r.
double tortoise_ahead(double spin, double r) {
    const double root = std::sqrt((1 - spin) * (1 + spin)), outer = 0.5 * (1 + root), inner = 0.5 * (1 - root);
    return std::log(r) + (outer * std::log1p(-outer / r) - inner * std::log1p(-inner / r)) / root;
}

// What is known of a photon where it is seen, or traced on from; `theta` and `climb` towards where it came from.
struct Launch {
    double r, theta;
    double phi;            // Boyer and Lindquist's, or if `falls` the ingoing azimuth
    bool falls;            // it fell in: traced as it is, otherwise its mirror image
    double energy, l_over_sine, p_theta, climb;   // climb: Sigma dr/dlambda
    double p_r;            // of the chart, of what is traced
};

class Path {
public:
    // late() = base + ..., see there; T counts from the camera's `from`; along: the affine parameter so far.
    struct Start {
        double base, from, along = 0;
    };
    Path(double spin, const Launch& launch, const Start& start);
    KerrRay trace(int most_crossings, const KerrWatch& watch);

private:
    void add_crossing(const State& before, double taken, double along, KerrRay& ray) const;
    void show(const State& before, double taken, double along, const KerrWatch& watch) const;
    KerrPlace place_of(const State& there, double azimuth) const;
    State stepped(const State& from, double length) const {
        State to = from;
        Stepper().do_step([this](const State& s, State& d, double) { chart_.slope(sense_ * energy_, s, d); }, to, 0.0, length);
        return to;
    }
    double boyer_lindquist(double chart_azimuth, double r) const { return phi_ - sense_ * (chart_azimuth - chart_.ahead(r, root_)); }
    double climbing(const State& s, const State& slope) const;
    Launch mirrored() const;
    double far_part(const State& s) const { return std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]); }
    // The chart's t is v - r of what is traced: of the mirror image -t + r_* - r. With w = t - sense |x| of the state the camera's clock less t
    // is base + sense w + |x| - sense (r_* - r).
    double passed(const State& s) const { return start_.base + sense_ * s[6] / kClockUnit; }
    double delay_from(const State& s, const State& slope, double r) const;
    double late(const State& s, double r) const { return passed(s) + far_part(s) - sense_ * tortoise_ahead(spin_, r); }

    Chart chart_;
    Start start_;
    double spin_, root_, outer_, phi_, energy_, momentum_, scale_ = 1;
    double sense_;     // 1: the mirror image, forward; -1: the photon itself, backward
    double azimuth_;   // in the chart, windings kept
    bool stays_ = false;
    State state_{};
};

// The mirror image has the energy and L_z of the photon, and moves in r and theta towards where that came from. Traced backward the
// photon has the opposite momentum.
Path::Path(double spin, const Launch& launch, const Start& start)
    : chart_{0.5 * spin, launch.falls ? -1.0 : 1.0}, start_(start), spin_(spin), root_(std::sqrt((1 - spin) * (1 + spin))), outer_(0.5 * (1 + root_)),
      phi_(launch.phi), energy_(launch.energy), momentum_(launch.l_over_sine * std::sin(launch.theta)), sense_(chart_.sense) {
    const double a = chart_.a, r = launch.r, sine = std::sin(launch.theta), cosine = std::cos(launch.theta);
    const double l_over_sine = sense_ * launch.l_over_sine;
    // To Cartesian components: x + iy = (r + ia) sin(theta) e^{i psi}, psi = 0 at the camera but for what the chart is ahead.
    const double psi = launch.falls ? 0 : chart_.ahead(r, root_) - std::atan2(a, r), c = std::cos(psi), s = std::sin(psi);
    azimuth_ = psi + std::atan2(a, r);
    const double height = std::abs(cosine) < kOnEquator ? 0.0 : cosine;
    state_[0] = (r * c - a * s) * sine;
    state_[1] = (r * s + a * c) * sine;
    state_[2] = r * height;
    // Components along d(place)/dr, d(place)/dtheta and the unit vector of psi, an oblique frame on which p is known.
    const Vec3 by_r{c * sine, s * sine, cosine}, by_theta{(r * c - a * s) * cosine, (r * s + a * c) * cosine, -r * sine};
    const Vec3 by_psi{-(r * s + a * c), r * c - a * s, 0};   // over sine
    const Vec3 n0 = cross(by_theta, by_psi), n1 = cross(by_psi, by_r), n2 = cross(by_r, by_theta);
    const double volume = dot(by_r, n0);
    const Vec3 p = (launch.p_r * n0 + launch.p_theta * n1 + l_over_sine * n2) / volume;
    state_[3] = p.x, state_[4] = p.y, state_[5] = p.z;
    scale_ = std::max(1.0, r);
    start_.base -= far_part(state_);
    stays_ = height == 0.0 && std::abs(launch.p_theta) < kStaysThere * std::abs(energy_);
}

// p_r of the chart of the mirror image, with x^2 - y^2 = Delta K, y = climb: (x + y)/Delta - E.
double mirror_p_r(double a, double r, double delta, double sine, const Launch& l) {
    const double x = l.energy * (r * r + a * a) - a * l.l_over_sine * sine, w = l.l_over_sine - a * l.energy * sine;
    const double carter = l.p_theta * l.p_theta + w * w;
    return (l.climb < 0 ? carter / (x - l.climb) : (x + l.climb) / delta) - l.energy;
}

double horizons_apart(double spin) { return std::sqrt((1 - spin) * (1 + spin)); }
double delta_at(double spin, double r) {
    const double root = horizons_apart(spin);
    return (r - 0.5 * (1 + root)) * (r - 0.5 * (1 - root));
}

Launch launch_of(double spin, const KerrStart& start) {
    const double a = 0.5 * spin, r = start.r, sine = std::sin(start.theta), cosine = std::cos(start.theta);
    const double sigma = r * r + a * a * cosine * cosine, across = r * r + a * a, delta = delta_at(spin, r);
    const double area = across * sigma + a * a * r * sine * sine;   // (r^2 + a^2)^2 - Delta a^2 sin^2
    const double lapse = std::sqrt(delta * sigma / area), drag = a * r / area, girth = std::sqrt(area / sigma);
    Launch l{};
    l.r = r, l.theta = start.theta, l.phi = start.phi, l.falls = false;
    l.l_over_sine = -girth * start.look.z;   // the photon runs against the look direction
    l.energy = lapse * length(start.look) + drag * l.l_over_sine * sine;
    l.p_theta = std::sqrt(sigma) * start.look.y, l.climb = std::sqrt(sigma * delta) * start.look.x;
    l.p_r = mirror_p_r(a, r, delta, sine, l);
    return l;
}

// Down with the metric of ingoing coordinates. What is traced outward fell in.
Launch launch_of(double spin, const KerrPhoton& photon) {
    const long double a = 0.5L * spin, r = photon.r, sine = std::sin(photon.theta), cosine = std::cos(photon.theta), drag = a * sine;
    const long double sigma = r * r + a * a * cosine * cosine, hole = r / sigma;
    const auto& [v, radial, theta, phi] = photon.p;
    Launch l{};
    l.r = photon.r, l.theta = photon.theta, l.phi = photon.phi;
    l.energy = static_cast<double>((1 - hole) * v - radial + drag * hole * phi);
    l.l_over_sine = static_cast<double>(-drag * hole * v - drag * radial + (r * r + a * a + drag * drag * hole) * phi);
    l.p_theta = static_cast<double>(-sigma * theta), l.climb = static_cast<double>(-sigma * radial);
    const double outer = 0.5 * (1 + horizons_apart(spin));
    l.falls = l.climb >= 0 || photon.r <= outer;
    if (l.falls) {
        l.p_r = -(static_cast<double>(v - drag * phi) - l.energy);
    } else {
        l.phi -= kerr_azimuth_ahead(spin, photon.r);
        l.p_r = mirror_p_r(0.5 * spin, photon.r, delta_at(spin, photon.r), std::sin(photon.theta), l);
    }
    return l;
}

// dr/dlambda of what is traced.
double Path::climbing(const State& s, const State& slope) const {
    const double a = chart_.a, r = chart_.radius(s), r2 = r * r, sum = r2 * r2 + a * a * s[2] * s[2];
    return (s[0] * slope[0] + s[1] * slope[1]) * r2 * r / sum + s[2] * slope[2] * r * (r2 + a * a) / sum;
}

// Of a photon that was traced as it is and has turned: what its mirror image begins with here.
Launch Path::mirrored() const {
    const double a = chart_.a, r = chart_.radius(state_), cosine = state_[2] / r, across = r * r + a * a;
    const double flat = std::hypot(state_[0], state_[1]), sine = flat / std::sqrt(across), sigma = r * r + a * a * cosine * cosine;
    const double co = flat > 0 ? state_[0] / flat : 1, si = flat > 0 ? state_[1] / flat : 0, girth = std::sqrt(across);
    State slope{};
    chart_.slope(sense_ * energy_, state_, slope);
    Launch l{};
    l.r = r, l.theta = std::atan2(sine, cosine), l.falls = false, l.energy = energy_;
    l.phi = boyer_lindquist(azimuth_, r);
    l.p_theta = girth * cosine * (co * state_[3] + si * state_[4]) - r * sine * state_[5];
    l.l_over_sine = sense_ * girth * (co * state_[4] - si * state_[3]);
    l.climb = sigma * climbing(state_, slope);
    l.p_r = mirror_p_r(a, r, delta_at(spin_, r), sine, l);
    return l;
}

// T, from far out on the way to the sky: late + from - r_*, without the difference of |x| and r, and what is left of a straight way.
double Path::delay_from(const State& s, const State& slope, double r) const {
    const Vec3 x{s[0], s[1], s[2]}, v{slope[0], slope[1], slope[2]};
    const double across = chart_.a * chart_.a * (s[0] * s[0] + s[1] * s[1]) / (r * r + chart_.a * chart_.a);   // a^2 sin^2
    const double b = length(cross(x, v)) / length(v), far = far_part(s), rest = b * b / (far + std::sqrt((far - b) * (far + b)));
    return passed(s) + across / (far + r) + start_.from - (sense_ > 0 ? 2 * tortoise_ahead(spin_, r) : 0) + rest;
}

KerrPlace Path::place_of(const State& there, double azimuth) const {
    const double r = chart_.radius(there), flat = std::hypot(there[0], there[1]) / std::sqrt(r * r + chart_.a * chart_.a);
    return {r, std::atan2(flat, there[2] / r), boyer_lindquist(azimuth, r), late(there, r)};
}

// What of a step is outside the horizon; its azimuths are counted from where it began.
void Path::show(const State& before, double taken, double along, const KerrWatch& watch) const {
    const auto outside = [this](const State& s) { return chart_.radius(s) > outer_ * (1 + kAboveHorizon); };
    const bool begins = outside(before), ends = outside(state_);
    if (!begins && !ends) return;
    State slope{};
    chart_.slope(sense_ * energy_, before, slope);
    const auto azimuth = [this, before, slope, from = azimuth_](const State& there) { return from + turned(from, before, there, slope); };
    const auto at = [this, before, azimuth, along](double a) {
        const State there = stepped(before, a - along);
        return place_of(there, azimuth(there));
    };
    KerrStep step{along, along + taken, {}, {}, at};
    if (begins != ends) {
        double out = begins ? 0 : taken, in = taken - out;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (out + in);
            (outside(stepped(before, middle)) ? out : in) = middle;
        }
        (begins ? step.to : step.from) = along + out;
    }
    step.begin = begins ? place_of(before, azimuth_) : at(step.from);
    step.end = ends ? place_of(state_, azimuth(state_)) : at(step.to);
    watch(step);
}

// The zero of z within the step: Newton's steps on its length, each taken whole from where the step began.
void Path::add_crossing(const State& before, double taken, double along, KerrRay& ray) const {
    double low = 0, high = taken, at = 0;
    State there = before, d{};
    for (int i = 0; i < 60; ++i) {
        chart_.slope(sense_ * energy_, there, d);
        double next = at - there[2] / d[2];
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double move = std::abs(next - at);
        at = next;
        there = stepped(before, at);
        ((there[2] > 0) == (before[2] > 0) ? low : high) = at;
        if (move <= 1e-15 * std::abs(at) || there[2] == 0) break;
    }
    chart_.slope(sense_ * energy_, there, d);
    const double r = chart_.radius(there);
    if (!(r > outer_)) return;
    const double phi = boyer_lindquist(azimuth_ + turned(azimuth_, before, there, d), r);
    // Sigma dr/dlambda = Delta p_r of what is traced; the photon's own has the other sign.
    const double delta = (r - outer_) * (r - 0.5 * (1 - root_));
    ray.crossings.push_back({r, phi, -climbing(there, d) * r * r / (delta * energy_), along + at, late(there, r)});
}

KerrRay Path::trace(int most_crossings, const KerrWatch& watch) {
    using boost::numeric::odeint::controlled_step_result;
    KerrRay ray;
    ray.energy = energy_;
    ray.l_z = momentum_ / energy_;
    auto stepper = boost::numeric::odeint::make_controlled(kStepTolerance, kStepTolerance, Stepper());
    const auto system = [this](const State& s, State& d, double) { chart_.slope(sense_ * energy_, s, d); };
    ray.fate = chart_.radius(state_) > outer_ ? Fate::kCaptured : Fate::kNoSky;
    // From inside, what does not come out through this horizon: E (r_+^2 + a^2) <= a L.
    if (ray.fate == Fate::kNoSky && !(energy_ * outer_ > chart_.a * momentum_)) return ray;
    bool outside = ray.fate == Fate::kCaptured;
    const double sky = std::max(kSky, 1e6 * scale_);
    double lambda = 0, length = 0.01 * scale_;
    for (int i = 0; i < kMostSteps; ++i) {
        const State before = state_;
        const double from = lambda;
        if (stepper.try_step(system, state_, lambda, length) == controlled_step_result::fail) continue;
        const double taken = lambda - from, along = start_.along + from;
        if (watch) show(before, taken, along, watch);
        State slope{};
        chart_.slope(sense_ * energy_, before, slope);
        const bool crossed = before[2] != 0 && (before[2] > 0) != (state_[2] > 0) && !stays_;
        if (crossed && static_cast<int>(ray.crossings.size()) < most_crossings) add_crossing(before, taken, along, ray);
        azimuth_ += turned(azimuth_, before, state_, slope);
        const double r = chart_.radius(state_);
        if (r <= outer_ && outside) return ray;
        outside = outside || r > outer_;
        chart_.slope(sense_ * energy_, state_, slope);
        if (sense_ < 0 && outside && climbing(state_, slope) < 0) {   // on its way to the past horizon
            const Start here{late(state_, r) + tortoise_ahead(spin_, r), start_.from, start_.along + lambda};
            KerrRay rest = Path(spin_, mirrored(), here).trace(most_crossings - static_cast<int>(ray.crossings.size()), watch);
            ray.crossings.insert(ray.crossings.end(), rest.crossings.begin(), rest.crossings.end());
            if (rest.fate == Fate::kEscaped) ray.fate = rest.fate, ray.sky = rest.sky, ray.phi_inf = rest.phi_inf, ray.delay = rest.delay;
            return ray;
        }
        if (outside && std::isnan(ray.delay) && r > kFarForTime * scale_) ray.delay = delay_from(state_, slope, r);
        if (r < sky) continue;
        ray.fate = Fate::kEscaped;   // the motion's direction, nearer to the sky's than the place's
        const double place = std::atan2(state_[1], state_[0]), motion = std::atan2(slope[1], slope[0]);
        ray.phi_inf = phi_ - sense_ * (azimuth_ + std::remainder(motion - place, 2 * M_PI));
        const double flat = std::hypot(slope[0], slope[1]), all = std::hypot(flat, slope[2]);
        ray.sky = {flat / all * std::cos(ray.phi_inf), flat / all * std::sin(ray.phi_inf), slope[2] / all};
        return ray;
    }
    return ray;   // still winding: closer to the critical ray than a double can tell
}

}  // namespace

Vec3 KerrPlace::flat() const { return r * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}; }

double way_between(const KerrPlace& from, const KerrPlace& to) {
    const double sine = std::max(std::sin(from.theta), std::sin(to.theta));
    return std::hypot(to.r - from.r, std::max(from.r, to.r) * std::hypot(to.theta - from.theta, sine * (to.phi - from.phi)));
}

KerrRay trace_kerr(double spin, const KerrStart& start, int most_crossings, const KerrWatch& watch) {
    const double ahead = tortoise_ahead(spin, start.r);
    return Path(spin, launch_of(spin, start), {ahead, start.r + ahead}).trace(most_crossings, watch);
}

KerrRay trace_kerr(double spin, const KerrPhoton& photon, int most_crossings, bool falls, const KerrWatch& watch) {
    const Launch launch = launch_of(spin, photon);
    // late = 0 at the camera, or r_* - r; inside the horizon what is traced fell in, and r_* is not asked for.
    const double sense = launch.falls ? -1 : 1, ahead = falls && launch.falls ? 0 : tortoise_ahead(spin, photon.r);
    return Path(spin, launch, {falls ? ahead + sense * ahead : sense * ahead, photon.r + (falls ? 0 : ahead)}).trace(most_crossings, watch);
}

double kerr_azimuth_ahead(double spin, double r) {
    const Chart chart{0.5 * spin};
    return chart.ahead(r, horizons_apart(spin)) - std::atan2(chart.a, r);
}

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
