#include "reference/carried_axes.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "spacetime/axial_metric.h"

namespace nullscope::reference {
namespace {

constexpr double kCarryTolerance = 2e-14;  // of a step
constexpr double kFarAway = 1e3;           // of the camera's r and of the disc's plane: nothing is met beyond
constexpr double kFirstCarryStep = 1e-3;   // of r
constexpr double kLeastCarryStep = 1e-14;
constexpr int kMostCarrySteps = 20000;
constexpr int kCrossingSteps = 60;

class KerrCarrying final : public CarryingMetric {
public:
    explicit KerrCarrying(const KerrHole& hole) : chart_{hole} {}
    NullForm at(const Vec3& x) const override {
        const double a = chart_.a, r = chart_.radius(x), r2 = r * r, across = r2 + a * a,
                     sum = r2 * r2 + a * a * x.z * x.z;
        NullForm form;
        form.f = chart_.twice_mass(r) * r2 * r / sum;
        form.l = {1, (r * x.x + a * x.y) / across, (r * x.y - a * x.x) / across, x.z / r};
        const std::array<double, 3> place{x.x, x.y, x.z};
        for (std::size_t i = 0; i < 3; ++i) {
            const double dr = i == 2 ? x.z * r * across / sum : place[i] * r2 * r / sum;
            const double dsum = 4 * r2 * r * dr + (i == 2 ? 2 * a * a * x.z : 0.0);
            form.df[i] = form.f * ((3 + chart_.mass_log_slope(r)) * dr / r - dsum / sum);
            const double turn = 2 * r * dr / across;
            form.dl[i] = {0,
                          (dr * x.x + (i == 0   ? r
                                       : i == 1 ? a
                                                : 0.0)) /
                                  across -
                              form.l[1] * turn,
                          (dr * x.y + (i == 1   ? r
                                       : i == 0 ? -a
                                                : 0.0)) /
                                  across -
                              form.l[2] * turn,
                          ((i == 2 ? 1.0 : 0.0) - form.l[3] * dr) / r};
        }
        return form;
    }
    double radius(const Vec3& x) const override { return chart_.radius(x); }
    double a() const override { return chart_.a; }

private:
    KerrChart chart_;
};

class SphericalCarrying final : public CarryingMetric {
public:
    explicit SphericalCarrying(const Spacetime& spacetime) : spacetime_(spacetime) {}
    NullForm at(const Vec3& x) const override {
        const double r = length(x);
        const auto equator = spacetime_.equator(r);
        NullForm form;
        form.f = equator ? 1 + equator->g.tt : kNotANumber;
        const double slope = equator ? equator->slope.tt : kNotANumber;
        const std::array<double, 3> n{x.x / r, x.y / r, x.z / r};
        form.l = {1, n[0], n[1], n[2]};
        for (std::size_t i = 0; i < 3; ++i) {
            form.df[i] = slope * n[i];
            for (std::size_t j = 0; j < 3; ++j) form.dl[i][j + 1] = ((i == j ? 1.0 : 0.0) - n[i] * n[j]) / r;
            form.dl[i][0] = 0;
        }
        return form;
    }
    double radius(const Vec3& x) const override { return length(x); }

private:
    const Spacetime& spacetime_;
};

double along(const FourVector& covariant, const FourVector& v) {
    return covariant[0] * v[0] + covariant[1] * v[1] + covariant[2] * v[2] + covariant[3] * v[3];
}

// -Gamma^mu_ab k^a v^b of g = eta + F l l, whose inverse is eta - F l l.
FourVector turning(const NullForm& form, const FourVector& k, const FourVector& v) {
    // derivatives of F l_b v^b along k, of F l_b k^b along v, and by each coordinate of F (l k)(l v)
    const double lk = along(form.l, k), lv = along(form.l, v);
    double f_k = 0, f_v = 0;
    FourVector l_k{}, l_v{};
    for (std::size_t i = 0; i < 3; ++i) {
        f_k += form.df[i] * k[i + 1], f_v += form.df[i] * v[i + 1];
        for (std::size_t m = 0; m < 4; ++m) l_k[m] += form.dl[i][m] * k[i + 1], l_v[m] += form.dl[i][m] * v[i + 1];
    }
    FourVector lower{};
    for (std::size_t m = 0; m < 4; ++m)
        lower[m] = f_k * form.l[m] * lv + form.f * (l_k[m] * lv + form.l[m] * along(l_k, v)) + f_v * form.l[m] * lk +
                   form.f * (l_v[m] * lk + form.l[m] * along(l_v, k));
    for (std::size_t i = 0; i < 3; ++i)
        lower[i + 1] -= form.df[i] * lk * lv + form.f * (along(form.dl[i], k) * lv + lk * along(form.dl[i], v));
    for (double& part : lower) part *= -0.5;
    const FourVector up{-form.l[0], form.l[1], form.l[2], form.l[3]};
    const double raised = form.f * along(lower, up);
    return {-lower[0] - raised * up[0], lower[1] - raised * up[1], lower[2] - raised * up[2],
            lower[3] - raised * up[3]};
}

using CarryState = CarriedRay::State;

Vec3 place_of(const CarryState& s) { return {s[0], s[1], s[2]}; }
FourVector vector_of(const CarryState& s, std::size_t from) { return {s[from], s[from + 1], s[from + 2], s[from + 3]}; }

// By lambda over the square of the distance from the centre, against the photon's way.
struct CarrySlope {
    const CarryingMetric& metric;
    void operator()(const CarryState& s, CarryState& d, double) const {
        const Vec3 x = place_of(s);
        const double scale = -dot(x, x);
        const NullForm form = metric.at(x);
        const FourVector k = vector_of(s, 3);
        for (std::size_t i = 0; i < 3; ++i) d[i] = scale * k[i + 1];
        for (const std::size_t from : {std::size_t{3}, std::size_t{7}, std::size_t{11}}) {
            const FourVector turn = turning(form, k, vector_of(s, from));
            for (std::size_t m = 0; m < 4; ++m) d[from + m] = scale * turn[m];
        }
        d[15] = -scale;
    }
};

// A vector at the camera, whose azimuth is 0, in t = v - r and x + iy = (r + ia) sin(theta) e^{i phi~}.
FourVector in_chart(double a, const CameraSpec& camera, const std::array<long double, 4>& v) {
    const double sine = std::sin(camera.theta), cosine = std::cos(camera.theta);
    const auto [vv, vr, vt, vp] = v;
    const std::complex<double> at{camera.r, a};
    const std::complex<double> flat =
        std::complex<double>(static_cast<double>(vr) * sine) +
        at * std::complex<double>(static_cast<double>(vt) * cosine, static_cast<double>(vp));
    return {static_cast<double>(vv - vr), flat.real(), flat.imag(),
            static_cast<double>(vr) * cosine - camera.r * static_cast<double>(vt) * sine};
}

// Rows of the tetrad, in sum.
std::array<long double, 4> combined(const Tetrad& tetrad, const std::array<double, 4>& factors) {
    std::array<long double, 4> sum{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t m = 0; m < 4; ++m) sum[m] += factors[i] * tetrad[i][m];
    return sum;
}

CarryState beginning_of(const CarryingMetric& metric, const CameraSpec& camera, const Tetrad& tetrad, Vec3 n) {
    const double a = metric.a(), sine = std::sin(camera.theta);
    // Forward is turned to n by the shortest way, right and up with it; n.z is backward.
    const double by = 1 / (1 - n.z);
    const auto right = combined(tetrad, {0, 1 - n.x * n.x * by, -n.x * n.y * by, n.x * (1 - n.z) * by}),
               up = combined(tetrad, {0, -n.x * n.y * by, 1 - n.y * n.y * by, n.y * (1 - n.z) * by}),
               k = combined(tetrad, {1, -n.x, -n.y, -n.z});
    const FourVector vectors[] = {in_chart(a, camera, k), in_chart(a, camera, right), in_chart(a, camera, up)};
    CarryState s{camera.r * sine, a * sine, camera.r * std::cos(camera.theta)};
    for (std::size_t i = 0; i < 3; ++i)
        std::copy_n(vectors[i].begin(), 4, s.begin() + 3 + 4 * static_cast<std::ptrdiff_t>(i));
    return s;
}

using CarryStepper = boost::numeric::odeint::runge_kutta_fehlberg78<CarryState, double, CarryState, double,
                                                                    boost::numeric::odeint::array_algebra>;

// Of a step, over what is allowed; not a number where the step is of no use.
double carry_error(const CarryState& state, const CarryState& wrong) {
    double most = 0;
    for (std::size_t n = 0; n < state.size(); ++n) {
        const double error = std::abs(wrong[n]) / (kCarryTolerance * (1 + std::abs(state[n])));
        if (!(error <= most)) most = error;
    }
    return most;
}

// Within a step, where z is 0: the step anew and shorter, halved until neither side is left.
CarryState at_plane(const CarrySlope& slope, const CarryState& before, double taken) {
    double low = 0, high = taken;
    CarryState there = before;
    for (int i = 0; i < kCrossingSteps; ++i) {
        const double middle = 0.5 * (low + high);
        CarryStepper().do_step(slope, before, 0.0, there, middle);
        ((there[2] > 0) == (before[2] > 0) ? low : high) = middle;
    }
    return there;
}

}  // namespace

double CarryingMetric::product(const Vec3& x, const FourVector& u, const FourVector& v) const {
    const NullForm form = at(x);
    return -u[0] * v[0] + u[1] * v[1] + u[2] * v[2] + u[3] * v[3] + form.f * along(form.l, u) * along(form.l, v);
}

std::unique_ptr<const CarryingMetric> carrying_metric(const Spacetime& spacetime) {
    if (const AxialMetric* axial = spacetime.axial())
        return std::make_unique<KerrCarrying>(KerrHole(2 * axial->a(), 2 * std::sqrt(axial->charge2())));
    if (!spacetime.can_have_disc()) return nullptr;
    return std::make_unique<SphericalCarrying>(spacetime);
}

CarriedRay::CarriedRay(const CarryingMetric& metric, const CameraSpec& camera, const Tetrad& tetrad, Vec3 direction)
    : metric_(metric), state_(beginning_of(metric, camera, tetrad, direction)), step_(kFirstCarryStep / camera.r) {}

bool CarriedRay::advance(double length) {
    const CarrySlope slope{metric_};
    const Vec3 x = place_of(state_);
    const double speed = dot(x, x) * std::hypot(state_[4], state_[5], state_[6]), most = length / speed;
    for (;;) {
        taken_ = std::min(step_, most);
        if (!(taken_ > kLeastCarryStep)) return false;
        CarryState next = state_, wrong;
        CarryStepper().do_step(slope, state_, 0.0, next, taken_, wrong);
        const double error = carry_error(next, wrong);
        const double factor = error > 0 ? std::clamp(0.9 * std::pow(error, -0.125), 0.2, 4.0) : 4.0;
        if (error <= 1) {
            step_ = std::max(step_, factor * taken_);
            state_ = next;
            return true;
        }
        step_ = factor * taken_;
    }
}

CarriedAxes CarriedRay::now() const {
    return {place_of(state_), vector_of(state_, 3), vector_of(state_, 7), vector_of(state_, 11)};
}

std::optional<CarriedAxes> carried_axes(const CarryingMetric& metric, const CameraSpec& camera, const Tetrad& tetrad,
                                        Vec3 direction, int crossing) {
    const CarrySlope slope{metric};
    CarriedRay ray(metric, camera, tetrad, direction);
    const double farthest = kFarAway * std::max(camera.r, 1.0);
    for (int i = 0, met = 0; i < kMostCarrySteps; ++i) {
        const CarryState before = ray.state();
        if (!ray.advance(HUGE_VAL)) return std::nullopt;
        if (length(place_of(ray.state())) > farthest) return std::nullopt;
        if (before[2] == 0 || (before[2] > 0) == (ray.state()[2] > 0) || ++met < crossing) continue;
        const CarryState there = at_plane(slope, before, ray.taken());
        return CarriedAxes{place_of(there), vector_of(there, 3), vector_of(there, 7), vector_of(there, 11)};
    }
    return std::nullopt;
}

}  // namespace nullscope::reference
