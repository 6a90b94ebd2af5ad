#include "spacetime/formula_places.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>

namespace nullscope {
namespace {

constexpr double kStep = 1.01;     // of r, between two looks at A
constexpr int kSplits = 6;         // of a step, where the bounds of A do not keep it off 0
constexpr double kNoDepth = 1e-3;  // of the bounds of A at one r, which are some 1e4 roundings wide
constexpr int kSamples = 2000;     // at the slope of V
constexpr double kSame = 1e-12;    // B A and R/r that are 1 for every r: some roundings of what formulas subtract
constexpr double kFallsOff = 4;    // of A, at a tenth of the distance from its zero: 10 if that is simple
constexpr double kNoTerm = 1e-12;  // of an expansion far out: some roundings

Error wrong(std::string_view key, const std::string& what, std::string_view allowed) {
    return bad_key(std::string(key), what, std::string(allowed));
}

constexpr std::string_view kHole = "A > 0 outside of a horizon, where it falls through 0";
constexpr std::string_view kFlat =
    "A, A B and R/r that have limits above 0 far out, in powers of 1/r, or a cosmological constant besides";

// The root between low, where positive(low), and high.
template <class Positive>
double divide(double low, double high, const Positive& positive) {
    for (int i = 0; i < 2000; ++i) {
        const double middle = 0.5 * (low + high);
        if (!(middle > std::fmin(low, high) && middle < std::fmax(low, high))) break;
        (positive(middle) ? low : high) = middle;
    }
    return high;
}

double v_of(const MetricFormulas& f, double zeta) {
    const double across = f.areal_radius(1.0 / zeta);
    return f.lapse2(1.0 / zeta) / (across * across);
}

// What A is far out: V of zeta, beginning with v_at_sky + c zeta^2. With c or A B other than 1 an angle is missing all around.
Status check_far(const MetricFormulas& f, const Expansion& v_far, const Expansion& density_far) {
    if (v_far.reach() > 0.0 && density_far.reach() == 0.0)
        return wrong(f.has_b() ? "B" : "R", "A B has no positive limit, or no expansion in powers of 1/r far out",
                     kFlat);
    if (v_far.reach() == 0.0) return wrong("A", "has no expansion in powers of 1/r far out", kFlat);
    if (std::fabs(v_far.term(1)) > kNoTerm || !(v_far.term(2) > kNoTerm) || !(density_far.term(0) > kNoTerm))
        return wrong("A", "A and R/r have no limits above 0 far out", kFlat);
    if (v_far.term(0) > 0.0)
        return wrong("A", "grows as r^2 far out: light comes back from infinity in a finite time", kFlat);
    return Done{};
}

// A passes through 0 at this zeta, as against coming down to where doubles or their differences end: above and below it A falls off
// with the distance, at some distance from it; two horizons may lie close together.
bool passes(const MetricFormulas& f, double zeta) {
    const auto falls_off = [&](double sign, double apart) {
        const double far = f.lapse2(1.0 / (zeta * (1.0 - sign * apart))) * sign;
        const double near = f.lapse2(1.0 / (zeta * (1.0 - sign * 0.1 * apart))) * sign;
        return near > 0.0 && far > kFallsOff * near;
    };
    for (double apart = 1e-3; apart > 1e-10; apart *= 0.1)
        if (falls_off(1.0, apart) && falls_off(-1.0, apart)) return true;
    return false;
}

// Where A is least between two places, or greatest (sign -1), if that is not at an end.
std::optional<double> turns(const MetricFormulas& f, double from, double to, double sign) {
    const auto falls = [&](double zeta) {
        const auto r = expr::Series<double, 2>(1.0) / expr::Series<double, 2>::variable(zeta);
        return sign * f.lapse2(r).of_power(1) < 0.0;
    };
    if (!falls(from) || falls(to)) return {};
    return divide(from, to, falls);
}

// The first place on the way from one place to another where A is not on the same side of 0 any more as at the first: two horizons may lie
// within a step. Where A is above 0 it also ends where it comes down to 0 but for roundings.
std::optional<double> other_side(const MetricFormulas& f, double from, double to, bool above, int splits = kSplits) {
    const double sign = above ? 1.0 : -1.0;
    const auto over = [&](double zeta) { return !(sign * f.lapse2(1.0 / zeta) > 0.0); };
    const expr::Interval all = f.lapse2_range(1.0 / to, 1.0 / from);
    if (above ? all.low > 0.0 : all.high < 0.0) return {};
    if (splits > 0) {
        const double middle = 0.5 * (from + to);
        if (const auto before = other_side(f, from, middle, above, splits - 1)) return before;
        return other_side(f, middle, to, above, splits - 1);
    }
    if (const auto turn = turns(f, from, to, sign)) {
        const expr::Interval there = f.lapse2_range(1.0 / *turn, 1.0 / *turn);
        const double depth = above ? kNoDepth * (there.high - there.low) : 0.0;
        if (over(*turn) || sign * f.lapse2(1.0 / *turn) < depth) return turn;
    }
    return over(to) ? std::optional(to) : std::nullopt;
}

// A from far out inward: where static observers are, between horizons.
Status find_horizons(const MetricFormulas& f, FormulaPlaces& places) {
    const auto lapse2 = [&](double zeta) { return f.lapse2(1.0 / zeta); };
    const auto above = [&](double zeta) { return lapse2(zeta) > 0.0; };
    double before = 1.0 / FormulaPlaces::kFarthest;
    bool rests = lapse2(before) > 0.0;
    if (rests && places.v_at_sky < 0.0)
        return wrong("A", "the cosmological horizon lies beyond r = 1e6", "a larger cosmological constant, or none");
    if (!rests && places.v_at_sky == 0.0) return wrong("A", "is not above 0 at r = 1e6", kHole);
    for (double zeta = before * kStep; zeta < 1.0 / FormulaPlaces::kNearest; before = zeta, zeta *= kStep) {
        const double a = lapse2(zeta);
        if (!std::isfinite(a))
            return wrong("A", fmt::format("is not finite at r = {:.6g}, outside of any horizon", 1.0 / zeta), kHole);
        for (auto turn = other_side(f, before, zeta, rests); turn; turn = other_side(f, before, zeta, rests)) {
            if (rests) {
                places.horizon = above(*turn) ? *turn : divide(before, *turn, above);
                if (passes(f, places.horizon)) return Done{};
                return wrong("A",
                             fmt::format("comes down to 0 at r = {:.6g} without passing through it, within the "
                                         "precision of doubles",
                                         1.0 / places.horizon),
                             kHole);
            }
            places.outer_horizon = divide(*turn, before, above);
            before = *turn, rests = true;
        }
    }
    return wrong("A", rests ? "there is no horizon: A stays above 0 down to r = 0.001" : "is nowhere above 0", kHole);
}

// Where V comes down to its value at infinity, behind the photon sphere.
Status find_end(const MetricFormulas& f, FormulaPlaces& places) {
    places.end = places.horizon;
    if (places.v_at_sky == 0.0) return Done{};
    const auto above = [&](double zeta) { return v_of(f, zeta) - places.v_at_sky > 0.0; };
    double before = places.horizon;
    for (double zeta = before * kStep; zeta < 1.0 / FormulaPlaces::kNearest; before = zeta, zeta *= kStep) {
        if (!std::isfinite(v_of(f, zeta))) break;
        if (above(zeta)) continue;
        places.end = divide(before, zeta, above);
        return Done{};
    }
    return wrong("A", "A/R^2 does not fall below its value far out behind the horizon",
                 "a smaller cosmological constant");
}

Status check_density(MetricFormulas& f, double end) {
    if (!f.tilted()) return Done{};
    bool product = true, areal = true;
    for (int i = 1; i < kSamples; ++i) {  // not at the end itself, where A = 0 and B may not be finite
        const double r = kSamples / (end * i), ab = f.lapse2(r) * f.stretch2(r), across = f.areal_radius(r);
        if (!(ab > 0.0 && std::isfinite(ab)))
            return wrong("B", fmt::format("A B is {:.6g} at r = {:.6g}", ab, r),
                         "A B > 0 and finite down to the horizon");
        if (!(across > 0.0 && std::isfinite(across)))
            return wrong("R", fmt::format("is {:.6g} at r = {:.6g}", across, r),
                         "R > 0 and finite down to the horizon");
        product = product && std::fabs(ab - 1.0) < kSame;
        areal = areal && std::fabs(across / r - 1.0) < kSame;
    }
    if (product && areal) f.forget_tilt();
    return Done{};
}

// V rises from the sky to the photon sphere and falls from there to the end.
Status find_photon_sphere(const MetricFormulas& f, FormulaPlaces& places) {
    const auto slope = [&](double zeta) { return f.v<2>(zeta).of_power(1); };
    const auto rises = [&](double zeta) { return slope(zeta) > 0.0; };
    bool rising = true;
    for (int i = 1; i <= kSamples; ++i) {
        const double zeta = places.end * i / kSamples, at = slope(zeta);
        if (!std::isfinite(at))
            return wrong("A", fmt::format("A/R^2 has no derivative at r = {:.6g}", 1.0 / zeta), kHole);
        if ((at > 0.0) == rising) continue;
        if (!rising)
            return wrong(
                "A", fmt::format("there are several photon spheres, at r = {:.6g} and further in", 1.0 / places.photon),
                "A/R^2 with one maximum outside of the horizon");
        places.photon = divide(places.end * (i - 1) / kSamples, zeta, rises);
        rising = false;
    }
    if (rising) return wrong("A", "there is no photon sphere outside of the horizon", "A/R^2 with one maximum there");
    return Done{};
}

}  // namespace

Result<FormulaPlaces> find_places(MetricFormulas& formulas, const Expansion& v_far, const Expansion& density_far) {
    FormulaPlaces places;
    if (Status far = check_far(formulas, v_far, density_far); !far) return far.error();
    places.v_at_sky = v_far.term(0);
    if (Status found = find_horizons(formulas, places); !found) return found.error();
    if (Status found = find_end(formulas, places); !found) return found.error();
    if (Status good = check_density(formulas, places.end); !good) return good.error();
    if (Status found = find_photon_sphere(formulas, places); !found) return found.error();
    return places;
}

}  // namespace nullscope
