#include "spacetime/potential_survey.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace nullscope {
namespace {

constexpr double kSurveyFarthest = RayPotential::kFarthest, kSurveyNearest = RayPotential::kNearest;
constexpr double kLook = 1.01;  // of r, between two looks
constexpr double kTouches =
    1e-9;  // of A, that it comes down to between two looks, of what it is at them: some roundings of the formula
constexpr double kBounded = 0.02;  // of the power of x that V is next to the end: it is a constant there
constexpr double kAlike = 1e-9;    // of V, that neighbouring extrema differ by at least

using SlopeJet = expr::Series<double, 2>;

struct Found {
    double r, v;
    bool greatest;  // else least
};

struct Survey {
    const MetricFormulas& f;
    PotentialSurvey made{};
    std::vector<Found> extrema{};  // of V, inward
    double outermost = kSurveyFarthest, end = 0.0;
    bool touches = false;

    double lapse2(double r) const { return f.lapse2(r); }
    double lapse_slope(double r) const { return f.lapse2(SlopeJet::variable(r)).of_power(1); }
    double v(double r) const {
        const double across = f.areal_radius(r);
        return f.lapse2(r) / (across * across);
    }
    double v_slope(double r) const {
        const SlopeJet at = SlopeJet::variable(r), across = f.areal_radius(at);
        return (f.lapse2(at) / (across * across)).of_power(1);
    }
    bool is_static(double r) const {
        const double a = f.lapse2(r), b = f.stretch2(r), across = f.areal_radius(r);
        return a > 0.0 && std::isfinite(a) && b > 0.0 && std::isfinite(b) && across > 0.0 && std::isfinite(across) &&
               v(r) > 0.0;
    }
    Status find_outermost();
    Status find_end();
    Status check_far() const;
    void find_extrema();
    Status find_ridge();
};

// Between two places, where `holds` at the first alone: the last place on its side.
template <class Holds>
double last_of(double holding, double other, const Holds& holds) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (holding + other);
        if (middle == holding || middle == other) break;
        (holds(middle) ? holding : other) = middle;
    }
    return other;
}

Status Survey::find_outermost() {
    const auto rests = [this](double r) { return is_static(r); };
    // Beyond a cosmological horizon A and B are below 0, and R is still a radius.
    for (; outermost > kSurveyNearest && !rests(outermost); outermost /= kLook) {
        const double ab = f.lapse2(outermost) * f.stretch2(outermost), across = f.areal_radius(outermost);
        if (!(across > 0.0))
            return bad_key("R", fmt::format("is {:.6g} at r = {:.6g}", across, outermost), "R > 0 far out");
        if (ab < 0.0) return bad_key("B", fmt::format("A B is {:.6g} at r = {:.6g}", ab, outermost), "A B > 0 far out");
    }
    if (!(outermost > kSurveyNearest))
        return bad_key("A", "is nowhere above 0 with B and R above 0 too", "a place where observers can be at rest");
    if (outermost == kSurveyFarthest) return Done{};
    if (std::isfinite(v(kSurveyFarthest))) {
        made.outer_horizon = last_of(outermost, outermost * kLook, rests);
        return Done{};
    }
    return bad_key("A", fmt::format("A, B or R is not finite at r = {}", kSurveyFarthest),
                   "formulas that are, out to there");
}

// Inward to where observers cannot be at rest any more: A falls through 0 or touches it, or a formula ends.
Status Survey::find_end() {
    const auto rests = [this](double r) { return is_static(r); };
    const auto falls = [this](double r) { return lapse_slope(r) > 0.0; };  // inward
    double before = outermost;
    for (double r = before / kLook; r > kSurveyNearest; before = r, r /= kLook) {
        if (falls(before) && !falls(r)) {
            const double least = last_of(before, r, falls);
            touches = lapse2(least) < kTouches * std::fmin(lapse2(before), lapse2(r));
            if (touches) {
                end = lapse2(least) > 0.0 ? least : last_of(before, least, rests);
                return Done{};
            }
        }
        if (rests(r)) continue;
        end = last_of(before, r, rests);
        return Done{};
    }
    return Done{};
}

// Light that goes out must be on its way for ever, and turn by less and less.
Status Survey::check_far() const {
    if (made.outer_horizon < kAnyRadius) return Done{};
    const auto power = [](double far, double near) { return std::log2(far / near); };
    const double r = kSurveyFarthest, half = 0.5 * kSurveyFarthest;
    const auto time = [this](double at) { return std::sqrt(f.stretch2(at) / f.lapse2(at)); };
    if (power(time(r), time(half)) < -1.2)
        return bad_key("A", "grows as r^2 far out: light comes back from infinity in a finite time",
                       "A/B that grows less than r^2 far out");
    const auto turn = [this](double at) {
        const double across = f.areal_radius(at);
        return std::sqrt(f.stretch2(at) * f.lapse2(at)) / (across * across);
    };
    if (power(turn(r), turn(half)) > -1.2)
        return bad_key("R", "space does not widen far out: light has no direction at infinity",
                       "R^2/sqrt(A B) that grows more than r far out");
    return Done{};
}

void Survey::find_extrema() {
    const auto rises = [this](double r) { return v_slope(r) < 0.0; };  // inward
    double before = outermost / kLook;
    for (double r = before / kLook; r > end + kSurveyNearest * std::fmax(end, 1.0); before = r, r /= kLook) {
        if (rises(before) == rises(r)) continue;
        const bool greatest = rises(before);
        const double at = last_of(before, r, [&](double place) { return rises(place) == greatest; }), there = v(at);
        if (!extrema.empty() && std::fabs(there - extrema.back().v) < kAlike * there) {
            extrema.pop_back();
            continue;
        }
        extrema.push_back({at, there, greatest});
    }
}

Status Survey::find_ridge() {
    const RayPotential& p = made.potential;
    made.comes_back = p.power_at_end() < -kBounded;
    const bool bounded = !made.comes_back && p.power_at_end() < kBounded;
    std::vector<Found> higher;  // than all further out
    for (const Found& one : extrema)
        if (one.greatest && (higher.empty() || one.v > higher.back().v)) higher.push_back(one);
    const double at_end = v(end), last = std::isfinite(at_end) ? 0.0 : p.nearest();
    const double v_last = last == 0.0 ? at_end : p.v(last);
    if (bounded && (higher.empty() || v_last > higher.back().v)) higher.push_back({end + last, v_last, true});
    if (higher.size() > 1)
        return bad_key("A",
                       fmt::format("light can circle at r = {:.6g} and at {:.6g}, and passes the outer circle on its "
                                   "way to the inner one and back",
                                   higher[0].r, higher[1].r),
                       "A/R^2 with an outermost maximum that is the highest one");
    if (higher.empty() && !made.comes_back)
        return bad_key("A", "A/R^2 has no maximum, and does not grow without bound inward: no ray turns",
                       "A/R^2 that turns light");
    if (!higher.empty()) {
        made.potential.expand_about(higher[0].r - end, higher[0].v);
        double least = higher[0].v;
        for (const Found& one : extrema)
            if (!one.greatest && one.r < higher[0].r && one.v < least) least = one.v, made.trough = one.r - end;
        return Done{};
    }
    made.soft = true;
    double flattest = 0.0, slope = 1e300;
    for (double r = outermost / kLook; r > end + 2.0 * p.nearest(); r /= kLook) {
        const double here = std::fabs(v_slope(r) * r / v(r));
        if (here < slope) slope = here, flattest = r;
    }
    made.potential.expand_about(flattest - end, v(flattest));
    return Done{};
}

}  // namespace

Result<PotentialSurvey> survey(const MetricFormulas& formulas) {
    Survey s{formulas};
    if (Status found = s.find_outermost(); !found) return found.error();
    if (Status good = s.check_far(); !good) return good.error();
    if (Status found = s.find_end(); !found) return found.error();
    const double a = formulas.lapse2(s.end);
    if (s.touches || (s.end > 0.0 && std::isfinite(a) && formulas.lapse2(0.999999 * s.end) < 0.0))
        s.made.horizon = s.end;
    s.made.potential = RayPotential(formulas, s.end);
    s.find_extrema();
    if (Status found = s.find_ridge(); !found) return found.error();
    return s.made;
}

}  // namespace nullscope
