#include "table/ray_sweep.h"

#include <algorithm>
#include <cmath>

#include "numeric/gauss.h"

namespace nullscope {
namespace {

constexpr double kSweepTolerance = 3e-12;                    // rad, of a panel
constexpr int kSweepPanels = 200, kFarPanels = 20;           // at most, of a part of the way
constexpr double kLeastPlace = 1e-20, kLeastOfAll = 1e-290;  // of r, and r_s: never 0
constexpr double kBesideTurn = 1e-5;                         // of the turning point
constexpr double kFarOut = 1e3;                              // r from which on 1/r is the variable

// Panels are halved as long as there are any left: where formulas have no more digits no halving helps.
template <class Rate>
double halved_sweep(const Rate& rate, double low, double high, double whole, int& left_over) {
    const double middle = 0.5 * (low + high), left = gauss_rule(kTenNode, kTenWeight, low, middle, rate),
                 right = gauss_rule(kTenNode, kTenWeight, middle, high, rate), sum = left + right;
    if (!(std::fabs(sum - whole) > kSweepTolerance * std::max(1.0, 0.1 * sum)) || --left_over < 0) return sum;
    return halved_sweep(rate, low, middle, left, left_over) + halved_sweep(rate, middle, high, right, left_over);
}

template <class Rate>
double sweep_integral(const Rate& rate, double low, double high, int panels = kSweepPanels) {
    if (!(high > low)) return 0.0;
    return halved_sweep(rate, low, high, gauss_rule(kTenNode, kTenWeight, low, high, rate), panels);
}

// y: the distance from `origin`, which is the ridge's x or 0.
struct Way {
    const PotentialSurvey& world;
    double q2, d, origin;

    const RayPotential& p() const { return world.potential; }
    double rest(double y) const {
        const double off = origin > 0.0 || p().ridge().x == 0.0 ? y : y - p().ridge().x;
        if (!world.soft && p().beside_ridge(off)) return d + p().below(off);
        return q2 - p().v(origin + y);
    }
    double rate(double y) const { return p().density(origin + y) / std::sqrt(std::max(rest(y), 1e-300)); }
    // The root between two places, by halves of the logarithm: P < 0 at the lower one.
    double turn(double low, double high) const {
        for (int i = 0; i < 70; ++i) {
            const double middle = std::sqrt(low) * std::sqrt(high);
            if (!(middle > low && middle < high)) break;
            (rest(middle) < 0.0 ? low : high) = middle;
        }
        return std::max(high, low);
    }
    double octaves(double from, double to) const {
        double sum = 0.0;
        for (double low = from; low < to; low *= 2.0)
            sum += sweep_integral([this](double y) { return rate(y); }, low, std::min(2.0 * low, to));
        return sum;
    }
    double to_sky_from(double from) const {
        const double shift = p().end() + origin, far = std::max(from, kFarOut - shift);
        const auto by_inverse = [this](double zeta) {
            const double r = 1.0 / zeta, x = r - p().end();
            return p().density(x) * r * r / std::sqrt(std::max(q2 - p().v(x), 1e-300));
        };
        return octaves(from, far) + sweep_integral(by_inverse, 0.0, 1.0 / (shift + far), kFarPanels);
    }
};

// Between the turning point e and y by s = sqrt(y - e), as far as 2 e. Next to e a difference of V says nothing: P/s^2 is a line there.
struct BesideTurn {
    const Way& way;
    double turn, reach, constant, slope;
    BesideTurn(const Way& on, double at) : way(on), turn(at), reach(kBesideTurn * at) {
        const double one = way.rest(turn + reach) / reach, two = way.rest(turn + 2.0 * reach) / (2.0 * reach);
        slope = (two - one) / reach, constant = one - slope * reach;
    }
    double operator()(double s) const {
        const double s2 = s * s, over = s2 < reach ? constant + slope * s2 : way.rest(turn + s2) / s2;
        return 2.0 * way.p().density(way.origin + turn + s2) / std::sqrt(std::max(over, 1e-300));
    }
    double swept(double from, double to) const { return sweep_integral(*this, from, to); }
    // sqrt(y - e) of the camera, where slope^2 = P has its digits.
    double root_of(double camera, double slope_there) const {
        double s2 = std::max(camera - turn, 0.0);
        for (int i = 0; i < 4 && s2 < reach; ++i)
            s2 = slope_there * slope_there / std::max(constant + slope * s2, 1e-300);
        return std::sqrt(s2);
    }
};

double turned(const Way& way, double turn, double camera, double slope) {
    const BesideTurn beside(way, turn);
    const double s0 = beside.root_of(camera, slope), edge = std::sqrt(turn);
    double out = way.to_sky_from(std::max(camera, 2.0 * turn));
    if (s0 < edge) out += beside.swept(s0, edge);
    if (slope <= 0.0) return out;
    double in = beside.swept(0.0, std::min(s0, edge));
    if (s0 > edge) in += way.octaves(2.0 * turn, camera);
    return out + 2.0 * in;
}

}  // namespace

double swept_to_sky(const PotentialSurvey& world, const SweptRay& ray) {
    const RayPotential& p = world.potential;
    const double camera = ray.r - p.end();
    if (!world.soft && ray.d < 0.0) {
        const Way way{world, ray.q * ray.q, ray.d, p.ridge().x};
        const double y0 = std::max(camera - p.ridge().x, kLeastPlace * ray.r);
        return turned(way, way.turn(kLeastPlace * ray.r, y0), y0, ray.slope);
    }
    const Way way{world, ray.q * ray.q, ray.d, 0.0};
    if (!world.soft && ray.slope <= 0.0) return way.to_sky_from(camera);
    const double inside = world.soft ? camera : world.trough;
    double low = p.nearest();
    if (way.rest(low) > 0.0) low *= 0.5 * std::pow(way.q2 / p.v(low), 1.0 / p.power_at_end());
    low = std::max(low, kLeastOfAll);
    return turned(way, way.turn(low, inside), camera, ray.slope);
}

double swept_to_end(const PotentialSurvey& world, const SweptRay& ray) {
    const RayPotential& p = world.potential;
    const Way way{world, ray.q * ray.q, ray.d, 0.0};
    return way.octaves(p.nearest(), ray.r - p.end());
}

}  // namespace nullscope
