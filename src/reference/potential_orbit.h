// Orbits in a potential: (dzeta/dphi)^2 = (q^2 - V)/density^2, V = A/R^2 greatest on the photon sphere. What the metrics share that find
// them by quadrature: a ray where it is seen, and orbits of one or two monotone segments.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/plane_metrics.h"
#include "reference/root.h"
#include "reference/smooth_segment.h"

namespace nullscope::reference {

// At the camera. root_p = sqrt(q^2 - V), delta2 = q^2 - q_crit^2 and beyond = zeta0 - sphere do not follow from q and zeta0 in double.
struct PotentialStart {
    Long r, q, zeta0;
    int s;  // +1 towards the hole
    Long root_p, delta2, beyond;
};

// Hole: sphere, horizon (zeta; infinite where there is none and all light comes back), q_crit, lapse2(r), radius(r), p(q, zeta) = q^2 - V,
// below(x) = q_crit^2 - V(sphere + x), fall_speed(r) of what fell from rest at infinity (not a number where nothing does),
// has_circle(): light can stay on the photon sphere.
template <class Hole>
class PotentialMetric : public OrbitMetric {
public:
    explicit PotentialMetric(Hole hole) : hole_(std::move(hole)) {}
    std::optional<double> horizon_radius() const override {
        if (std::isinf(hole_.horizon)) return {};
        return static_cast<double>(1 / hole_.horizon);
    }
    double lapse(double r) const override { return std::sqrt(static_cast<double>(hole_.lapse2(r))); }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long q = std::max(ray.q, kLeastQ), zeta0 = ray.zeta0, p = ray.q < kRadialQ ? hole_.p(q, zeta0) : 0;
        if (p < -kTurningSlack * q * q) return no_such_ray(ray, "zeta0", ": q^2 < V(zeta0)");
        const Long delta2 = (q - hole_.q_crit) * (q + hole_.q_crit);
        return orbit({1 / zeta0, q, zeta0, ray.s, std::sqrt(std::max(p, Long(0))), delta2, zeta0 - hole_.sphere});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long q = std::sqrt(hole_.lapse2(ray.r)) / hole_.radius(ray.r) / ray.n_t;
        return local(ray.r, q, q * std::abs(ray.n_r), ray.n_r <= 0 ? 1 : -1);
    }
    RainOrbit from_rain(const LocalRay& ray) const override {
        const Long w = hole_.fall_speed(ray.r), across = hole_.radius(ray.r) * ray.n_t;
        const auto [energy, outward] = RainStart<Long>(ray, w, -hole_.lapse2(ray.r) / (1 + w));
        if (!(energy > 0)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        return {local(ray.r, energy / across, std::abs(outward) / across, outward > 0 ? -1 : 1),
                static_cast<double>(1 / energy)};
    }

protected:
    // Of a ray that neither falls from the start nor is radial nor stays on the photon sphere.
    virtual std::unique_ptr<Orbit> swept(const PotentialStart& start) const = 0;
    const Hole hole_;

private:
    static constexpr double kRadialQ = 1e60, kLeastQ = 1e-60;  // beyond: radial; below: the regular limit

    // delta2 from q or, near the photon sphere, from P and below() as a product, whichever cancels less.
    std::unique_ptr<Orbit> local(Long r, Long q, Long root_p, int s) const {
        const Long radius = 1 / hole_.sphere, beyond = (radius - r) / (r / hole_.sphere), hill2 = hole_.below(beyond);
        Long delta2 = (q - hole_.q_crit) * (q + hole_.q_crit);
        if (root_p * root_p + std::abs(hill2) < hole_.q_crit * hole_.q_crit / 4) {
            const Long hill = std::sqrt(std::max(hill2, Long(0)));
            delta2 = hill > 0 ? (root_p - hill) * (root_p + hill) : root_p * root_p - hill2;
        }
        return orbit({r, q, 1 / r, s, root_p, delta2, beyond});
    }
    std::unique_ptr<Orbit> orbit(PotentialStart start) const {
        const double zeta0 = static_cast<double>(start.zeta0);
        if (start.s > 0 && start.zeta0 >= hole_.horizon)  // falls from the start
            return std::make_unique<StandingOrbit>(zeta0, Fate::kNoSky);
        if (!(start.q < kRadialQ)) {  // without a horizon in, and back the same way
            const bool escapes = start.s < 0 || std::isinf(hole_.horizon);
            return std::make_unique<StandingOrbit>(zeta0, escapes ? Fate::kEscaped : Fate::kCaptured);
        }
        if (start.delta2 == 0 && hole_.has_circle()) {
            if (start.root_p == 0) return std::make_unique<StandingOrbit>(zeta0, Fate::kNoSky, false);
            // The critical ray itself never ends; its neighbour, closer than any double q comes, does.
            start.delta2 = kNearlyCritical2;
        }
        return swept(start);
    }
};

// Of zeta: nearer to the turning point the camera's distance follows from root_p, with the digits of the view direction.
inline constexpr Long kBesideTurn = 0.1L;

struct Turn {
    Long zeta, off;  // off = zeta - sphere, with its own digits
};
// V = q^2 < q_crit^2, on the camera's side of the photon sphere: by the distance from that; far below the critical q by zeta itself.
template <class Hole>
Turn turning_point(const Hole& hole, const PotentialStart& start) {
    const int side = start.beyond < 0 ? -1 : 1;
    if (side < 0 && start.q < hole.q_crit / 2) {
        const auto excess = [&](Long z) { return -hole.p(start.q, z) / (start.q * start.q); };
        Long low = start.q / 2;
        while (excess(low) > 0) low /= 2;
        const Long zeta = root_of(excess, low, hole.sphere, 62);
        return {zeta, zeta - hole.sphere};
    }
    const Long wanted = std::sqrt(-start.delta2);
    const auto excess = [&](Long d) { return std::sqrt(std::max(hole.below(side * d), Long(0))) - wanted; };
    // V < 0 outside a cosmological horizon and inside the other one: there is a root before.
    const Long high = side < 0 ? hole.sphere * (1 - 1e-12L) : hole.horizon - hole.sphere;
    const Long off = side * (excess(high) > 0 ? root_of(excess, Long(0), high, 62) : high);
    return {hole.sphere + off, off};
}

// Distance t of the camera from a turning point. Beside it zeta0 - turn loses digits; there q^2 - V = t over(t), whose root is given, has
// them. The root next to zeta0 - turn.
template <class Over>
Long camera_distance(const PotentialStart& start, const Turn& turn, int side, const Over& over) {
    const Long apart = std::max(side * (start.beyond - turn.off), Long(0)), least = 1e-15L * turn.zeta;
    if (apart > kBesideTurn * turn.zeta) return apart;
    if (!(start.root_p > 0)) return 0;
    const Long given = 2 * std::log(start.root_p);
    const auto excess = [&](Long log_t) { return log_t + std::log(over(std::exp(log_t))) - given; };
    Long low = apart > least ? std::log(apart) : given - std::log(over(least)), high = low;
    for (Long step = 1e-3L; excess(low) >= 0 && step < 1e3L; step *= 2) low -= step;
    for (Long step = 1e-3L; excess(high) < 0 && step < 1e3L; step *= 2) high += step;
    if (!(excess(low) < 0 && excess(high) >= 0)) return apart;  // where rounding leaves no root, q^2 - V is flat
    return std::exp(root_of(excess, low, high, 62));
}

// What a segment tells of a ray. w: the variable in which dphi/dw is smooth.
struct LegEnds {
    bool to_sky;                // it ends there; else on the horizon
    Long nearest;               // zeta of the root of q^2 - V next to the sky, or of its least value
    double turn = kNotANumber;  // zeta of the turning point
    double first = 0;           // w there
    double camera = 0, end = 0;
    double panel = kPanel;
};

// Segment: its ends as LegEnds; rate(w) = dphi/dw, zeta(w), near_sky(w), which is zeta as a difference from the sky's end; sky_rate(zeta) =
// dphi/dzeta. Where delays are known root_p(w) and, of segments that turn, inward_delay().
template <class Segment>
class LeggedOrbit final : public Orbit {
public:
    template <class Hole>
    LeggedOrbit(const Hole& hole, const PotentialStart& start)
        : Orbit(static_cast<double>(start.zeta0)),
          q_(static_cast<double>(start.q)),
          segment_(hole, start),
          turns_(segment_.to_sky == (start.s > 0)),
          near_sky_(start.s < 0 && start.zeta0 < segment_.nearest / 4) {
        fate_ = segment_.to_sky ? Fate::kEscaped : start.zeta0 >= hole.horizon ? Fate::kNoSky : Fate::kCaptured;
        if (turns_) {
            turn_ = segment_.turn;
            to_turn_.emplace(segment_.camera, segment_.first, segment_.panel);
            turn_angle_ = std::abs(to_turn_->whole(rate()));
        }
        if (near_sky_) {
            angle_ = integrate_panels(sky_rate(), 0, place_);
        } else {
            const double camera = segment_.camera, end = segment_.end, first = segment_.first;
            if (turns_ && std::abs(camera - first) < std::abs(end - first)) {  // as it came, and on
                onward_ = to_turn_->backward();
                onward_->go_on(camera, end, segment_.panel);
            } else {
                onward_.emplace(turns_ ? first : camera, end, segment_.panel);
            }
            angle_ = (turns_ ? turn_angle_ : 0) + std::abs(onward_->whole(rate()));
        }
    }
    double delay() const override {
        if constexpr (requires { segment_.root_p(0.0); }) {
            if (fate_ != Fate::kEscaped) return kNotANumber;
            if (near_sky_)
                return integrate_panels(
                    [&](double z) { return segment_.sky_rate(z) / (q_ + 1 / segment_.sky_rate(z)); }, 0, place_);
            const auto [low, high] = std::minmax(segment_.camera, segment_.end);
            const double out = integrate_panels([&](double w) { return segment_.rate(w) / (q_ + segment_.root_p(w)); },
                                                low, high, segment_.panel);
            if constexpr (requires { segment_.inward_delay(); })
                if (turns_) return out + 2 * segment_.inward_delay();
            return out;
        }
        return kNotANumber;
    }

private:
    // A camera so far out that q^2 - V stays near q^2: in zeta itself angles of any smallness keep their digits.
    double place_at(double angle) const override {
        if (near_sky_) {
            if (!from_end_) from_end_.emplace(0, place_, kPanel);
            return (*from_end_)(sky_rate(), angle_ - angle);
        }
        if (turns_ && angle < turn_angle_) return segment_.zeta((*to_turn_)(rate(), -angle));
        const double from = turns_ ? segment_.first : segment_.camera, so_far = turns_ ? turn_angle_ : 0,
                     sense = from < segment_.end ? 1 : -1;
        // From the nearer end: next to the sky zeta is small, and its digits count from there.
        if (angle_ - angle < 0.5 * (angle_ - so_far)) {
            if (!from_end_) from_end_ = onward_->backward();
            const double w = (*from_end_)(rate(), sense * (angle - angle_));
            return segment_.to_sky ? segment_.near_sky(w) : segment_.zeta(w);
        }
        return segment_.zeta((*onward_)(rate(), sense * (angle - so_far)));
    }
    auto rate() const {
        return [this](double w) { return segment_.rate(w); };
    }
    auto sky_rate() const {
        return [this](double z) { return segment_.sky_rate(z); };
    }
    double q_;
    Segment segment_;
    bool turns_, near_sky_;
    mutable std::optional<PanelInverse> to_turn_, from_end_, onward_;  // from_end_: once places there are asked for
};

}  // namespace nullscope::reference
