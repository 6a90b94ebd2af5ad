// A static spherical metric as three formulas of r: A, B (by default 1/A) and R (by default r), in zeta = 1/r, where light's V = A/R^2
// is regular at infinity. Values, derivatives and expansions of any order come from one series arithmetic (expr/series.h).
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "expr/interval.h"
#include "expr/smooth.h"

namespace nullscope {

class MetricFormulas {
public:
    // texts: of "A" and, where they are given, "B" and "R". Errors: "KEY: what is wrong".
    static Result<MetricFormulas> parse(const std::map<std::string, std::string>& texts);

    bool tilted() const { return b_.has_value() || r_.has_value(); }  // B or R is not the default
    bool has_b() const { return b_.has_value(); }
    void forget_tilt() { b_.reset(), r_.reset(); }

    template <class Value>
    Value lapse2(const Value& r) const {
        return a_.value<double>(r);
    }
    // Contains A of every r between the two (expr/interval.h).
    expr::Interval lapse2_range(double low, double high) const;
    template <class Value>
    Value stretch2(const Value& r) const {  // B
        return b_ ? b_->value<double>(r) : Value(1.0) / lapse2(r);
    }
    template <class Value>
    Value areal_radius(const Value& r) const {
        return r_ ? r_->value<double>(r) : r;
    }
    // Of zeta, by powers of what is added to it: A zeta^2, V = A/R^2, and sqrt(A B) (r/R)^2, the density of dphi = ... dzeta/sqrt(q^2 - V).
    template <int n>
    expr::Series<double, n> scaled_lapse2(double zeta) const {
        const Place<n> p(zeta);
        return p.zeta * p.zeta * lapse2(p.r);
    }
    template <int n>
    expr::Series<double, n> v(double zeta) const {
        const Place<n> p(zeta);
        if (!r_) return p.zeta * p.zeta * lapse2(p.r);
        const auto across = areal_radius(p.r);
        return lapse2(p.r) / (across * across);
    }
    template <int n>
    expr::Series<double, n> density(double zeta) const {
        const Place<n> p(zeta);
        if (!tilted()) return expr::Series<double, n>(1.0);
        const auto part = p.zeta * areal_radius(p.r);
        return sqrt(lapse2(p.r) * stretch2(p.r)) / (part * part);
    }

private:
    template <int n>
    struct Place {
        expr::Series<double, n> zeta, r;
        explicit Place(double at)
            : zeta(expr::Series<double, n>::variable(at)), r(expr::Series<double, n>(1.0) / zeta) {}
    };
    expr::SmoothFormula a_;
    std::optional<expr::SmoothFormula> b_, r_;
    expr::Formula a_text_;  // of A, for bounds
};

// A power series about a place: how far from there it is good to a rounding, against its term of the power lead.
class Expansion {
public:
    static constexpr int kTerms = 24;
    Expansion() = default;
    // Nothing is known (reach 0) where a term is not finite. widest: where to begin.
    Expansion(const expr::Series<double, kTerms + 4>& series, int lead, double widest);
    double reach() const { return reach_; }
    bool holds(double x) const { return x <= reach_ && -x <= reach_; }
    double term(int power) const { return c_[static_cast<std::size_t>(power)]; }
    // The sum of c[k] x^(k - lead), k >= lead, and its derivative.
    double over_lead(double x) const;
    double over_lead_slope(double x) const;
    double over_lead_curvature(double x) const;

private:
    std::array<double, kTerms> c_{};
    int lead_ = 0;
    double reach_ = 0.0;
};

}  // namespace nullscope
