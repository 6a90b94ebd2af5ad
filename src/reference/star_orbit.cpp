// A star's orbits: those of the Schwarzschild exterior until they meet the surface, found by bracketing zeta_at(angle) = 1/radius.
#include <cmath>
#include <utility>

#include "reference/plane_metrics.h"
#include "reference/root.h"

namespace nullscope::reference {
namespace {

class UntilSurface : public Orbit {
public:
    // Of an orbit that meets the surface on the traced part; before its turning point if it is a flyby, which would turn inside.
    UntilSurface(std::unique_ptr<Orbit> bare, double surface) : Orbit(bare->zeta_at(0)), bare_(std::move(bare)) {
        const bool flyby = bare_->fate() == Fate::kEscaped;
        fate_ = Fate::kHit;
        angle_ = bare_->angle();
        if (!flyby) turn_ = bare_->turn();
        if (angle_ == 0) return;  // radial
        // zeta grows to 1/surface on the way to the turning point of a flyby, and after that of an orbit that rose first.
        const double turned = bare_->turn_angle(), low = turned == turned && !flyby ? turned : 0,
                     high = flyby ? turned : angle_;
        angle_ = meeting(surface, low, high);
    }
    double delay() const override { return kNotANumber; }

private:
    double place_at(double angle) const override { return bare_->zeta_at(angle); }
    double meeting(double surface, double low, double high) const {
        const auto depth = [&](double angle) {
            const double zeta = bare_->zeta_at(angle);
            return std::isfinite(zeta) ? zeta - surface : 1.0 - surface;  // at the horizon, where the bare orbit ends
        };
        const double at_low = depth(low), at_high = depth(high);
        if (!(at_low < 0)) return low;
        if (!(at_high > 0)) return high;  // grazes
        return root_of(depth, low, high, at_low, at_high, 52);
    }
    std::unique_ptr<Orbit> bare_;
};

class Star : public OrbitMetric {
public:
    explicit Star(double radius) : radius_(radius), exterior_(make_schwarzschild_orbits({})) {}
    double lapse(double r) const override { return r >= radius_ ? exterior_->lapse(r) : kNotANumber; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        if (ray.zeta0 * radius_ > 1) return bad_input("the camera is inside the star");
        TRY(bare, exterior_->from_reduced(ray));
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
        const double surface = 1 / radius_;
        const bool meets =
            bare->fate() == Fate::kCaptured || (bare->fate() == Fate::kEscaped && bare->turn() >= surface);
        return meets ? std::make_unique<UntilSurface>(std::move(bare), surface) : std::move(bare);
    }
    double radius_;
    std::unique_ptr<OrbitMetric> exterior_;
};

}  // namespace

OrbitMetricPtr make_star_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Star>(parameter_of(spec, "radius", 2.5));
}

}  // namespace nullscope::reference
