#include "observer/ball_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "expr/formula.h"
#include "numeric/dormand_prince.h"
#include "observer/spin_fall.h"
#include "scene/orbit_sense.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

// In the plane of `outward` and `onward`.
BallPlace in_plane(Vec3 outward, Vec3 onward, double r, double phi, double r_dot, double phi_dot) {
    const Vec3 e = std::cos(phi) * outward + std::sin(phi) * onward,
               across = std::cos(phi) * onward - std::sin(phi) * outward;
    return {r * e, r_dot * e + (r * phi_dot) * across};
}

Vec3 eastward(Vec3 outward) {
    const double rho = std::hypot(outward.x, outward.y);
    return rho > 0.0 ? Vec3{-outward.y / rho, outward.x / rho, 0} : Vec3{0, 1, 0};
}

// Free fall in a plane: r'' = -(A (1 + L^2/r^2))'/2 by proper time, phi' = L/r^2, t' = E/A.
class Fall {
public:
    static constexpr double kFrozen = 1e-6;      // of the horizon or the star: nearer to it as good as still
    static constexpr double kTolerance = 1e-11;  // of a step
    using State = std::array<double, 4>;         // t, r, dr/dtau, phi
    Fall(const Spacetime& spacetime, double r, double r_tau, double energy, double momentum)
        : spacetime_(spacetime), energy_(energy), momentum_(momentum), start_{0, r, r_tau, 0}, at_(start_) {
        least_radius_ = std::max(spacetime.horizon_radius().value_or(0.0), spacetime.surface_radius().value_or(0.0));
    }
    State at(double t) {
        if (std::fabs(t) <= kLong || !find_period()) return along(t);
        const double periods = std::floor(t / period_->time);
        State s = along(t - periods * period_->time);
        s[0] += periods * period_->time, s[3] += periods * period_->angle;
        return s;
    }
    BallPlace motion(double t, Vec3 outward, Vec3 onward) {
        const State s = at(t);
        const double r = s[1], rate = spacetime_.lapse_squared(r) / energy_;
        return in_plane(outward, onward, r + s[2] * rate * (t - s[0]), s[3] + momentum_ / (r * r) * rate * (t - s[0]),
                        s[2] * rate, momentum_ / (r * r) * rate);
    }

private:
    struct Period {
        double time, angle;  // from one smallest radius to the next
    };
    static constexpr double kFirstStep = 1e-2, kReached = 1e-7;
    static constexpr double kLong = 1e4;      // r_s/c: later, a bound orbit is known by its period
    static constexpr int kMostSteps = 20000;  // in which it is looked for; one that escapes takes ever longer ones

    bool is_frozen(double r) const { return r <= least_radius_ * (1.0 + kFrozen); }
    State step(const State& from, double h, State& wrong) const {
        return dormand_prince(
            from, h, [this](const State& s) { return slope(s); }, wrong);
    }
    // By a step of proper time, at most so long, into the future or the past. length: of the next.
    State stepped(const State& from, double most, double sense, double& length) const {
        const double rest = (from[1] - least_radius_) / std::max(std::fabs(from[2]), 1e-3);
        for (;;) {
            const double h = std::min({length, most, 0.1 * rest});  // no stage of a step is inside
            State wrong{};
            const State next = step(from, std::copysign(h, sense), wrong);
            double error = 0;
            for (const double x : wrong) error = std::max(error, std::fabs(x) / kTolerance);
            if (error > 1.0 || h == length) length = h * next_step_factor(error);
            if (error <= 1.0) return next;
        }
    }
    State along(double t) {
        const double sense = t >= 0.0 ? 1.0 : -1.0;
        if (sense * (t - at_[0]) < 0.0 || sense * at_[0] < 0.0) at_ = start_, length_ = kFirstStep;
        while (std::fabs(t - at_[0]) > kReached) {
            const double r = at_[1];
            if (is_frozen(r)) return {t, r, 0, at_[3]};
            const double left = std::fabs(t - at_[0]) * spacetime_.lapse_squared(r) / energy_;
            at_ = stepped(at_, left, t - at_[0], length_);
        }
        return at_;
    }
    // Whether the orbit is bound: is sought once.
    bool find_period() {
        if (std::exchange(sought_, true)) return period_.has_value();
        State s = start_;
        double length = kFirstStep;
        std::optional<State> first;
        for (int i = 0; i < kMostSteps && !is_frozen(s[1]) && !period_; ++i) {
            const State before = std::exchange(s, stepped(s, kLong, 1.0, length));
            if (!(before[2] < 0.0 && s[2] >= 0.0)) continue;
            const State least = least_radius(s);
            if (first) period_ = Period{least[0] - (*first)[0], least[3] - (*first)[3]};
            first = least;
        }
        return period_.has_value();
    }
    // Where dr/dtau is 0, by Newton's method from a place next to it.
    State least_radius(State s) const {
        for (int i = 0; i < 5; ++i) {
            const double h = -s[2] / slope(s)[2];
            State wrong{};
            if (!(std::fabs(h) < std::fabs(s[1]))) break;
            s = step(s, h, wrong);
        }
        return s;
    }
    State slope(const State& s) const {
        const double zeta = 1.0 / s[1], a = spacetime_.lapse_squared(s[1]);
        const double a_r = -zeta * zeta * spacetime_.orbit_equation()->lapse_slope(zeta);  // dA/dr
        const double l2 = momentum_ * momentum_;
        return {energy_ / a, s[2], -0.5 * a_r * (1.0 + l2 * zeta * zeta) + a * l2 * zeta * zeta * zeta,
                momentum_ * zeta * zeta};
    }
    const Spacetime& spacetime_;
    double energy_, momentum_, least_radius_, length_ = kFirstStep;
    State start_, at_;
    bool sought_ = false;
    std::optional<Period> period_;
};

Result<BallMotionAt> fall_about_spin(const AxialMetric& metric, const BallSpec& ball) {
    const Vec3 x = ball.position;
    const double r = length(x), theta = std::atan2(std::hypot(x.x, x.y), x.z);
    double azimuth = std::atan2(x.y, x.x);
    Vec3 v = ball.velocity;
    if (x.x == 0.0 && x.y == 0.0)  // on the axis every direction across is a southward one
        azimuth += std::atan2(v.z, v.y), v = {v.x, std::hypot(v.y, v.z), 0.0};
    if (!(r > metric.outer_horizon() && metric.metric(r, theta)[0][0] < 0.0))
        return bad_key("position", fmt::format("nothing can be at rest at {} from the centre", r),
                       "outside the ergosphere");
    auto fall = std::make_shared<SpinFall>(metric, SpinFall::Start{r, theta, v});
    return BallMotionAt([=](double t) {
        const SpinFall::Place at = fall->at(t);
        const double sine = std::sin(at.theta), cosine = std::cos(at.theta), phi = azimuth + at.phi;
        const Vec3 round{std::cos(phi), std::sin(phi), 0}, east{-round.y, round.x, 0};
        const Vec3 out = sine * round + Vec3{0, 0, cosine}, south = cosine * round - Vec3{0, 0, sine};
        return BallPlace{at.r * out, at.r_dot * out + at.r * at.theta_dot * south + at.r * sine * at.phi_dot * east};
    });
}

}  // namespace

Result<BallMotionAt> ball_motion(const Spacetime& spacetime, const BallSpec& ball) {
    const double r = length(ball.position);
    const Vec3 outward = ball.position / r, east = eastward(outward);
    if (ball.motion == BallMotion::kOrbit) {
        if (!spacetime.planar_rays() && ball.position.z != 0.0)
            return bad_key("position",
                           fmt::format("no circular orbit at z = {} about a rotating hole", ball.position.z),
                           "z = 0, in the equatorial plane");
        const auto orbit = circular_orbit(spacetime, r, sense_about(spacetime, ball.sense));
        if (!orbit)
            return bad_key("position", fmt::format("no circular orbit at {} from the centre", r),
                           "outside the photon sphere");
        return BallMotionAt(
            [=, omega = orbit->omega](double t) { return in_plane(outward, east, r, omega * t, 0, omega); });
    }
    if (ball.motion == BallMotion::kGeodesic && spacetime.axial() != nullptr)
        return fall_about_spin(*spacetime.axial(), ball);
    if (ball.motion == BallMotion::kGeodesic) {
        if (spacetime.orbit_equation() == nullptr)
            return bad_key("motion",
                           fmt::format("free fall of balls is not supported in metric \"{}\"", spacetime.name()),
                           "still, path");
        if (!camera_can_rest(spacetime, r))
            return bad_key("position", fmt::format("nothing can be at rest at {} from the centre", r),
                           allowed_radii(spacetime));
        const Vec3 v = ball.velocity, across = v.z * east + v.y * cross(east, outward);  // e_theta = e_phi x e_r
        if (!spacetime.bends_light())
            return BallMotionAt([=, position = ball.position, velocity = v.x * outward + across](double t) {
                return BallPlace{position + t * velocity, velocity};
            });
        const double speed = length(across), gamma = 1.0 / std::sqrt(1.0 - dot(v, v)),
                     lapse = std::sqrt(spacetime.lapse_squared(r));
        auto fall = std::make_shared<Fall>(spacetime, r, gamma * v.x * lapse, gamma * lapse, gamma * speed * r);
        const Vec3 onward = speed > 0.0 ? across / speed : east;
        return BallMotionAt([=](double t) { return fall->motion(t, outward, onward); });
    }
    std::array<std::shared_ptr<expr::Formula>, 3> way;
    for (const auto& [i, text] : {std::pair{0, &ball.x}, {1, &ball.y}, {2, &ball.z}}) {
        TRY(parsed, expr::Formula::parse(*text, {"t"}));
        way[static_cast<std::size_t>(i)] = std::make_shared<expr::Formula>(std::move(*parsed));
    }
    return BallMotionAt([=](double t) {
        const auto place = [&](double at) {
            const double values[] = {at};
            return Vec3{way[0]->value(values), way[1]->value(values), way[2]->value(values)};
        };
        const double h = 1e-4 * std::max(1.0, 1e-4 * std::fabs(t));
        return BallPlace{place(t), (place(t + h) - place(t - h)) / (2.0 * h)};
    });
}

}  // namespace nullscope
