// A star's orbits: those of the Schwarzschild exterior until they meet the surface, found by bracketing zeta_at(angle) = 1/radius.
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <utility>

#include "reference/plane_metrics.h"

namespace nullscope::reference {
namespace {

class UntilSurface : public Orbit {
public:
    UntilSurface(std::unique_ptr<Orbit> bare, double surface) : bare_(std::move(bare)) {
        fate_ = bare_->fate();
        angle_ = bare_->angle();
        turn_ = bare_->turn();
        const bool flyby = fate_ == Fate::kEscaped && turn_ >= surface;  // would turn inside
        if (fate_ != Fate::kCaptured && !flyby) return;
        fate_ = Fate::kHit;
        if (flyby) turn_ = kNotANumber;
        if (angle_ == 0) return;  // radial
        // zeta grows to 1/surface on the way to the turning point of a flyby, and after that of an orbit that rose first.
        const double turned = bare_->turn_angle(), low = turned == turned && !flyby ? turned : 0,
                     high = flyby ? turned : angle_;
        angle_ = meeting(surface, low, high);
    }
    double zeta_at(double angle) const override {
        return fate_ == Fate::kHit && angle > 0 && has_ended(angle) ? kNotANumber : bare_->zeta_at(angle);
    }
    double delay() const override { return fate_ == Fate::kEscaped ? bare_->delay() : kNotANumber; }

private:
    double meeting(double surface, double low, double high) const {
        const auto depth = [&](double angle) {
            const double zeta = bare_->zeta_at(angle);
            return std::isfinite(zeta) ? zeta - surface : 1.0 - surface;  // at the horizon, where the bare orbit ends
        };
        const double at_low = depth(low), at_high = depth(high);
        if (!(at_low < 0)) return low;
        if (!(at_high > 0)) return high;  // grazes
        std::uintmax_t steps = 100;
        const auto found = boost::math::tools::toms748_solve(depth, low, high, at_low, at_high,
                                                             boost::math::tools::eps_tolerance<double>(52), steps);
        return 0.5 * (found.first + found.second);
    }
    std::unique_ptr<Orbit> bare_;
};

class Star : public OrbitMetric {
public:
    explicit Star(double radius) : radius_(radius), exterior_(make_schwarzschild_orbits({})) {}
    double lapse(double r) const override { return r >= radius_ ? exterior_->lapse(r) : kNotANumber; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        if (ray.zeta0 * radius_ > 1) return bad_input("the camera is inside the star");
        auto bare = exterior_->from_reduced(ray);
        if (!bare) return bare.error();
        return ended(std::move(*bare));
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        return ended(exterior_->from_static(ray));
    }
    RainOrbit from_rain(const LocalRay& ray) const override {
        RainOrbit rain = exterior_->from_rain(ray);
        return {ended(std::move(rain.orbit)), rain.g};
    }

private:
    std::unique_ptr<Orbit> ended(std::unique_ptr<Orbit> bare) const {
        return std::make_unique<UntilSurface>(std::move(bare), 1 / radius_);
    }
    double radius_;
    std::unique_ptr<OrbitMetric> exterior_;
};

}  // namespace

OrbitMetricPtr make_star_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Star>(parameter_of(spec, "radius", 2.5));
}

}  // namespace nullscope::reference
