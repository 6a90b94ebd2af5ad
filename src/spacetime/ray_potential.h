// V = A/R^2 and the rate at which rays turn, of formulas whose V has not the one form of spherical_metric.h: no horizon, a zero of A that is
// not simple, no limit far out in powers of 1/r. In x = r - r_end, from where the formulas end (0 at a regular centre):
//     dphi = density dx / sqrt(q^2 - V).
// Polynomials in sixteenths of an octave of x, of V and density over a power of x each, good to some roundings; below kNearest of the
// scale both are powers of x.
#pragma once
#include <array>
#include <vector>

#include "spacetime/metric_formulas.h"

namespace nullscope {

// Where rays part.
struct Ridge {
    double x = 0.0, v = 0.0;  // of a photon sphere, or of the end where V is greatest there
    double bend = 0.0;        // -V''/2 there; 0: V has no maximum there, but ends
};

class RayPotential {
public:
    static constexpr double kFarthest = 1e6, kNearest = 1e-7;  // r; x over max(r_end, 1)
    RayPotential() = default;
    RayPotential(MetricFormulas formulas, double end);
    double end() const { return end_; }
    double nearest() const { return nearest_; }  // x
    double v(double x) const { return value(x, 0); }
    double density(double x) const { return value(x, 1); }
    // By r alone, without polynomials; not finite outside of the formulas' range.
    double v_by_formula(double r) const;
    double density_by_formula(double r) const;
    // The power of x that V is like next to the end: below 0 it grows without bound there, and all light comes back.
    double power_at_end() const { return power_[0]; }
    // The ridge whose expansion is used near it from now on; bend is found.
    void expand_about(double x, double v);
    const Ridge& ridge() const { return ridge_; }
    bool beside_ridge(double off) const { return about_.holds(off); }
    // V(ridge) - V(ridge + off), without a difference next to it.
    double below(double off) const {
        if (!about_.holds(off)) return ridge_.v - v(ridge_.x + off);
        return -off * (ridge_.bend > 0.0 ? off : 1.0) * about_.over_lead(off);
    }

private:
    static constexpr int kTerms = 12, kParts = 16;  // of a piece; pieces of an octave
    struct Piece {
        bool good = false;
        std::array<double, kTerms> c{};
    };
    double value(double x, std::size_t which) const;
    double by_formula(double r, std::size_t which) const {
        return which == 0 ? v_by_formula(r) : density_by_formula(r);
    }
    Piece piece_of(double low, double high, std::size_t which) const;

    MetricFormulas formulas_;
    double end_ = 0.0, nearest_ = 0.0;
    int first_octave_ = 0;
    std::array<std::vector<Piece>, 2> pieces_;
    std::array<double, 2> at_nearest_{}, power_{};
    Ridge ridge_;
    Expansion about_;  // of V by r, without its first term
};

}  // namespace nullscope
