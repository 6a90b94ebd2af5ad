// Straight lines, zeta = q sin(phi - phi_infinity): the flat case of the orbit interface.
#include <algorithm>
#include <cmath>

#include "reference/plane_metrics.h"

namespace nullscope::reference {
namespace {

// A straight line seen from the centre. The camera's view direction makes the angle alpha with the outward radius; the
// swept angle to infinity is alpha, and zeta = zeta0 sin(alpha - phi) / sin(alpha).
class StraightLine : public Orbit {
public:
    StraightLine(double zeta0, double n_r, double n_t) : Orbit(zeta0), n_r_(n_r), n_t_(n_t) {
        fate_ = Fate::kEscaped;
        angle_ = std::atan2(n_t, n_r);
        if (n_r <= 0 && n_t > 0) turn_ = zeta0 / n_t;
    }
    // v = t + r along the past-directed line: T = r (1 - cos(alpha)), as a product for outward rays.
    double delay() const override { return (n_r_ > 0 ? n_t_ * n_t_ / (1 + n_r_) : 1 - n_r_) / place_; }

private:
    double place_at(double angle) const override { return place_ * std::sin(angle_ - angle) / n_t_; }
    double n_r_, n_t_;
};

class Minkowski : public OrbitMetric {
public:
    double lapse(double) const override { return 1; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const double sine = ray.zeta0 / ray.q;  // 0 for the radial ray, q infinite
        if (sine > 1 + kTurningSlack) return no_such_ray(ray, "zeta0");
        const double cosine = std::sqrt(std::max(0.0, (ray.q - ray.zeta0) / ray.q * (1 + sine)));
        const bool radial = std::isinf(ray.q);
        return std::unique_ptr<Orbit>(
            std::make_unique<StraightLine>(ray.zeta0, -ray.s * (radial ? 1.0 : cosine), std::min(sine, 1.0)));
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        return std::make_unique<StraightLine>(1 / ray.r, ray.n_r, ray.n_t);
    }
};

}  // namespace

OrbitMetricPtr make_minkowski_orbits(const SpacetimeSpec&) { return std::make_unique<Minkowski>(); }

}  // namespace nullscope::reference
