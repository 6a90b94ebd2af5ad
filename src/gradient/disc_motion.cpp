#include "gradient/disc_motion.h"

#include <algorithm>
#include <cmath>

#include "numeric/gauss.h"

namespace nullscope {
namespace {

constexpr int kHeatTerms = 56;
constexpr double kFarthestCircle = 100;  // of the horizon's radius, where the search for the last one ends
constexpr int kCirclesTried = 400;

ThriceBent along_r(const Number& r) {
    ThriceBent x;
    x.value.value.value = r;
    x.d[0] = TwiceBent(1.0), x.value.d[0] = OnceBent(1.0), x.value.value.d[0] = Number(1.0);
    return x;
}
const Number& plain(const TwiceBent& x) { return x.value.value; }
const Number& slope_of(const TwiceBent& x) { return x.d[0].value; }
const Number& bend_of(const TwiceBent& x) { return x.d[0].d[0]; }

}  // namespace

DiscMotion::DiscMotion(const Flow& flow, double sense, const DiscLean& lean) : flow_(flow), sense_(sense), lean_(lean) {
    if (flow.has_horizon()) find_innermost();
}

DiscMotion::Circle DiscMotion::circle(const Number& r) const {
    const EquatorNumbers g = flow_.equator(along_r(r));
    const TwiceBent &tt = g.tt.d[0], &tp = g.tphi.d[0], &pp = g.phiphi.d[0];
    Circle c;
    const TwiceBent pull2 = tp * tp - tt * pp;  // 0 in flat space
    c.rate = ((plain(pull2).value > 0 ? sense_ * sqrt(pull2) : TwiceBent(0.0)) - tp) / pp;
    const TwiceBent down_t = g.tt.value + g.tphi.value * c.rate, down_phi = g.tphi.value + g.phiphi.value * c.rate;
    c.u_t = 1.0 / sqrt(-(down_t + down_phi * c.rate));
    c.energy = -(down_t * c.u_t), c.momentum = down_phi * c.u_t;
    return c;
}

// The least energy of all circles.
void DiscMotion::find_innermost() {
    const double horizon = 1 / flow_.innermost();
    const auto radius = [&](int i) {
        return horizon * std::pow(kFarthestCircle, (static_cast<double>(i) + 0.5) / kCirclesTried);
    };
    double least = 1, low = horizon, high = kFarthestCircle * horizon;
    for (int i = 1; i + 1 < kCirclesTried; ++i) {
        const double energy = plain(circle(Number(radius(i))).energy).value;
        if (energy < least) least = energy, low = radius(i - 1), high = radius(i + 1);
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high), slope = slope_of(circle(Number(middle)).energy).value;
        (slope > 0 ? high : low) = middle;
    }
    innermost_ = Number(0.5 * (low + high));
    const Circle last = circle(innermost_);  // the rest and the derivatives: a Newton step in duals
    innermost_ = innermost_ - slope_of(last.energy) / bend_of(last.energy);
}

Number DiscMotion::g(const Photon& photon, const RayGradient::Crossing& at) const {
    if (lean_.tilt != 0 && flow_.spin().value != 0) return leaning_g(photon, at);
    if (at.r.value < innermost_.value) return falling_g(photon, at);
    const Circle c = circle(at.r);
    return 1.0 / (plain(c.u_t) * (photon.energy - plain(c.rate) * at.around));
}

// Round the normal N the place moves by Omega N x n: of it Omega cos(tilt)/sin^2(theta) is along the azimuth, the rest along theta.
Number DiscMotion::leaning_g(const Photon& photon, const RayGradient::Crossing& at) const {
    const Number tilt = Number::variable(lean_.tilt, kSeedTilt), c = cos(tilt);
    const Number rate = 1.0 / (1.0 / plain(circle(at.r).rate) - flow_.spin() * (1.0 - c));
    const Number sine2 = 1.0 - at.cosine * at.cosine, east = rate * c / sine2;
    Number south2 = rate * rate * (1.0 - c * c / sine2);
    if (south2.value < 0) south2 = Number(0.0);
    const PlaceNumbers m = flow_.place(at.r, at.cosine);
    const Number squared = -(m.tt + east * (2.0 * m.tphi + m.phiphi * east) + m.thetatheta * south2);
    return sqrt(squared) / (photon.energy - rate * at.around);
}

// By who has no angular momentum, N^2 = -1/g^tt and omega = -g_tphi/g_phiphi, with the matter's e = E - omega L:
//     -N^2 (p . u) = (E_photon - omega l) e - N^2 L l/g_phiphi + climb fall,  fall^2 = e^2 - N^2 (1 + L^2/g_phiphi),
// climb = N sqrt(g_rr) dr/d(affine parameter), dr = w r^2 dlambda of the light as it runs.
Number DiscMotion::falling_g(const Photon& photon, const RayGradient::Crossing& at) const {
    const PlaceNumbers m = flow_.place(at.r, Number(0.0));
    const Circle last = circle(innermost_);
    const Number omega = -(m.tphi / m.phiphi), n2 = -(m.tt + omega * m.tphi);
    const Number &l = plain(last.momentum), &energy = plain(last.energy), e = energy - omega * l;
    const Number fall2 = e * e - n2 * (1.0 + l * l / m.phiphi);
    const Number fall = fall2.value > 0 ? sqrt(fall2) : Number(0.0);
    const Number climb = sqrt(n2 * m.rr) * at.rise * at.r * at.r / m.thetatheta;
    return n2 / (e * (photon.energy - omega * at.around) - n2 * l * at.around / m.phiphi + climb * fall);
}

namespace {

struct RingGain {
    Number gained, gain, rate_slope;  // (E - Omega L) L', E - Omega L, Omega'
    explicit RingGain(const DiscMotion::Circle& c)
        : gain(plain(c.energy) - plain(c.rate) * plain(c.momentum)), rate_slope(slope_of(c.rate)) {
        gained = gain * slope_of(c.momentum);
    }
    Number shed(const Number& sum, const Number& r) const {
        return -(rate_slope * sum / (4 * M_PI * (r * gain * gain)));
    }
};

// Of duals whose ends have derivatives.
Number gained_between(const DiscMotion& motion, const Number& low, const Number& high) {
    const Number middle = 0.5 * (low + high), half = 0.5 * (high - low);
    const auto gained = [&](const Number& r) { return RingGain(motion.circle(r)).gained; };
    Number sum(0.0);
    for (std::size_t i = 0; i < kGaussNode.size(); ++i)
        sum = sum + kGaussWeight[i] * (gained(middle - kGaussNode[i] * half) + gained(middle + kGaussNode[i] * half));
    return half * sum;
}

}  // namespace

AccretionHeat::AccretionHeat(const DiscMotion& motion, double outer) : motion_(motion) {
    constexpr double kPeakWithin = 5;  // last circles
    const Number& first = motion.innermost();
    outer_ = std::max(outer, kPeakWithin * first.value);
    // The integral at Chebyshev's places, and the sums over them that are the polynomials' factors.
    std::vector<Number> at(kHeatTerms, Number(0.0));
    Number before = first, sum(0.0);
    const auto angle = [](int place) { return M_PI * (place + 0.5) / kHeatTerms; };
    for (int i = kHeatTerms - 1; i >= 0; --i) {
        const double part = 0.5 * (1 + std::cos(angle(i)));
        const Number r = first * exp(part * log(Number(outer_) / first));
        sum = sum + gained_between(motion, before, r), before = r;
        at[static_cast<std::size_t>(i)] = sum;
    }
    for (int k = 0; k < kHeatTerms; ++k) {
        Number term(0.0);
        for (int i = 0; i < kHeatTerms; ++i) term = term + std::cos(k * angle(i)) * at[static_cast<std::size_t>(i)];
        terms_.push_back((k == 0 ? 1.0 : 2.0) / kHeatTerms * term);
    }
    // Where it is largest its derivative by r is 0: those by the metric are at a place that stays.
    double low = first.value, high = kPeakWithin * first.value;
    for (int i = 0; i < 80; ++i) {
        const double third = (high - low) / 3;
        const bool grows = flux(Number(low + third)).value < flux(Number(high - third)).value;
        (grows ? low : high) = grows ? low + third : high - third;
    }
    peak_ = flux(Number(0.5 * (low + high)));
}

Number AccretionHeat::depth(const Number& r) const {
    const Number& first = motion_.innermost();
    return 2.0 * (log(r / first) / log(Number(outer_) / first)) - 1.0;
}

Number AccretionHeat::flux(const Number& r) const {
    if (!(r.value > motion_.innermost().value)) return Number(0.0);
    const Number x = depth(r);
    Number last(0.0), before(0.0);  // Clenshaw's sum
    for (std::size_t k = terms_.size() - 1; k > 0; --k) {
        const Number next = terms_[k] + 2.0 * (x * last) - before;
        before = last, last = next;
    }
    return RingGain(motion_.circle(r)).shed(terms_[0] + x * last - before, r);
}

}  // namespace nullscope
