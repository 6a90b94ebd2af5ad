#include "spacetime/lamp_light.h"

#include <cmath>
#include <optional>

#include "numeric/nystrom.h"
#include "spacetime/axial_metric.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kLampStep = 0.06;   // of Mino's time, over the ray's quickest oscillation
constexpr int kLampRounds = 200;     // of the search for a ray: bisections, where nothing is faster
constexpr double kLampNear = 1e-12;  // of delta, where the search ends

// A number and its derivative by delta.
struct Varied {
    double value, slope;
};

// pi/(2 AGM(sqrt(k), sqrt(k - a2))), of d(theta)/sqrt(k - a2 sin^2) from the axis to the plane.
Varied time_to_plane(Varied k, double a2) {
    double x = std::sqrt(k.value), y = std::sqrt(k.value - a2), dx = 0.5 * k.slope / x, dy = 0.5 * k.slope / y;
    while (std::fabs(x - y) > 1e-15 * x) {
        const double root = std::sqrt(x * y), slope = 0.5 * (dx * y + x * dy) / root;
        x = 0.5 * (x + y), dx = 0.5 * (dx + dy), y = root, dy = slope;
    }
    return {0.5 * M_PI / x, -0.5 * M_PI / (x * x) * dx};
}

// Where a ray meets the plane: zeta by delta, and by Mino's time.
struct Arrival {
    Varied zeta;
    double slope;
};

class LampRays {
public:
    LampRays(const Spacetime& spacetime, double height) : start_(1.0 / height) {
        if (const AxialMetric* rotating = spacetime.axial())
            a2_ = rotating->a() * rotating->a(), charge2_ = rotating->charge2();
        else
            orbit_ = spacetime.orbit_equation();
        lapse2_ = -spacetime.metric(height, 0.0)[0][0];
        size2_ = height * height + a2_;
        farthest_ = spacetime.horizon_radius() ? 1.0 / *spacetime.horizon_radius() : INFINITY;
    }
    double lamp_energy() const { return 1.0 / std::sqrt(lapse2_); }  // of a photon of unit energy at infinity; u^t too
    double farthest() const { return farthest_; }                    // zeta

    // A zeta of infinity: it falls in before; 0: it keeps to the axis, outward.
    Arrival at(double delta) const {
        const Arrival falls_in{{INFINITY, 0.0}, 0.0}, leaves{{0.0, 0.0}, 0.0};
        const double sine = std::sin(delta), cosine = std::cos(delta), over = size2_ / lapse2_;
        const Varied k{over * sine * sine, 2.0 * over * sine * cosine};  // Delta(h) = lapse2 (h^2 + a^2)
        if (!(k.value > a2_)) return cosine > 0.0 ? falls_in : leaves;
        const Varied time = time_to_plane(k, a2_);
        const double steps = std::ceil(time.value * std::sqrt(k.value + a2_ + 1.0) / kLampStep);
        constexpr double kMostSteps = 1e5;  // of rays that wait by the axis
        if (!(steps < kMostSteps)) return cosine > 0.0 ? falls_in : leaves;
        const double h = time.value / steps, stretch = size2_ * start_ * start_;
        const auto force = [&](double x, double dx) { return force_at(k, x, dx); };
        BentState<std::array<double, 4>> ray{{start_, cosine * stretch, 0.0, -sine * stretch}, {}};
        ray.bend = force(start_, 0.0);
        for (int n = 0; n < static_cast<int>(steps); ++n) {
            ray = nystrom_step(ray, h, force);
            if (!(ray.state[0] < kBeyond * farthest_)) return falls_in;
        }
        const auto& [zeta, slope, by_delta, slope_by_delta] = ray.state;
        return Arrival{{zeta, by_delta + slope * time.slope}, slope};
    }

private:
    static constexpr double kBeyond =
        4.0;  // as far as a ray is followed, so that one that arrives at the horizon has others beside it

    // zeta'' and its derivative by delta.
    std::array<double, 2> force_at(Varied k, double x, double dx) const {
        if (orbit_ != nullptr) {
            const double half = orbit_->half_v_slope(x);
            return {-k.value * half, -k.value * orbit_->half_v_curvature(x) * dx - k.slope * half};
        }
        const double outer = a2_ + charge2_, one = 2.0 * a2_ - k.value, two = 1.5 * k.value,
                     three = 2.0 * (a2_ * a2_ - k.value * outer);
        const double by_k = x * (-1.0 + x * (1.5 - 2.0 * outer * x));
        return {x * (one + x * (two + x * three)), (one + x * (2.0 * two + 3.0 * x * three)) * dx + by_k * k.slope};
    }

    double start_, a2_ = 0.0, charge2_ = 0.0, lapse2_ = 1.0, size2_ = 1.0, farthest_ = INFINITY;
    const OrbitEquation* orbit_ = nullptr;
};

// The ray to a ring: zeta falls as delta grows. Newton's steps, halves of the bracket where these leave it.
std::optional<std::pair<double, Arrival>> ray_to(const LampRays& rays, double zeta, double guess) {
    double low = 0.0, high = M_PI, delta = guess;
    for (int round = 0; round < kLampRounds; ++round) {
        const Arrival found = rays.at(delta);
        const double step = (zeta - found.zeta.value) / found.zeta.slope;
        if (std::fabs(step) < kLampNear) return std::pair(delta, found);
        (found.zeta.value < zeta ? high : low) = delta;
        const bool inside = delta + step > low && delta + step < high;
        delta = inside ? delta + step : 0.5 * (low + high);
    }
    return std::nullopt;
}

}  // namespace

std::vector<double> lamp_light(const Spacetime& spacetime, const std::vector<double>& radii, const LampPost& lamp,
                               Sense sense) {
    std::vector<double> light(radii.size(), 0.0);
    const LampRays rays(spacetime, lamp.height);
    const DiscMatterFlow matter(spacetime, sense);
    double guess = 0.5;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double r = radii[i], zeta = 1.0 / r;
        if (!(zeta < rays.farthest())) continue;
        const auto found = ray_to(rays, zeta, guess);
        if (!found) continue;
        const auto& [delta, arrival] = *found;
        guess = delta;
        const MatterVelocity u = matter.at(r);
        const double inward = u.u_r == 0.0 ? 0.0 : arrival.slope * r * r / spacetime.equator(r)->across2;
        const double energy = (u.u_t + inward * u.u_r) / rays.lamp_energy();
        light[i] = std::sin(delta) / std::fabs(arrival.zeta.slope) * zeta * zeta * zeta / rays.lamp_energy() *
                   std::pow(energy, lamp.index - 1.0);
    }
    return light;
}

}  // namespace nullscope
