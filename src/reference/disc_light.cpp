#include "reference/disc_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>

#include "light/black_body.h"
#include "reference/disc_emissivity.h"
#include "reference/seen_light.h"

namespace nullscope::reference {
namespace {

// Values at a radius and at four on either side of it, and derivatives by r from them: of eighth order, some 1e-12 relative.
constexpr int kBeside = 4;
constexpr double kApart = 0.01, kApartOfWay = 1.0 / 16;  // of r; of the way to the horizon
template <class Values>
using Nearby = std::array<Values, 2 * kBeside + 1>;
template <class Values, class Function>
Nearby<Values> nearby(const Function& f, double r, double apart = kApart) {
    Nearby<Values> values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = f(r * (1 + (static_cast<int>(i) - kBeside) * apart));
    return values;
}
template <class Values>
double derivative(const Nearby<Values>& values, double Values::*part, double r, double apart = kApart) {
    const auto d = [&](std::size_t n) { return values[kBeside + n].*part - values[kBeside - n].*part; };
    return (d(1) * 4.0 / 5 - d(2) / 5 + d(3) * 4.0 / 105 - d(4) / 280) / (apart * r);
}

// sigma T^4 = flux Mdot c^2 / r_s^2. Of a hole of one solar mass: Eddington's luminosity, and r_s in m.
double accretion_temperature_K(const AccretionSpec& accretion, double flux) {
    constexpr double kEddington_W = 1.25707e31, kSun_m = 2953.250077, kStefan_W_m2_K4 = 5.670374419e-8,
                     kEfficiency = 0.1;
    const double heat_W = accretion.rate_eddington * accretion.mass_suns * kEddington_W / kEfficiency,
                 r_s = accretion.mass_suns * kSun_m;
    return std::sqrt(std::sqrt(flux * heat_W / r_s / r_s / kStefan_W_m2_K4));
}

// What leaves a half-space of electrons that scatter by Thomson's law (Chandrasekhar, Radiative Transfer, 1960, chapter X), over its flux F
// (pi F its power per area): with polarization along the meridian and across it
//     I_l = 3/(8 sqrt 2) q H_l(mu),   I_r = 3/(8 sqrt 2) (mu + c) H_r(mu),   q^2 = 2 (1 - c^2),
// H of characteristic functions 3/4 (1 - mu^2) and 3/8 (1 - mu^2); c and q by the flux that both give.
class ElectronAtmosphere {
public:
    ElectronAtmosphere() {
        using Rule = boost::math::quadrature::gauss<double, 30>;  // of the root of mu: H has a term mu ln mu
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const double side : {-1.0, 1.0}) {
                const double root = 0.5 * (1 + side * Rule::abscissa()[i]);
                mu_.push_back(root * root), weight_.push_back(root * Rule::weights()[i]);
            }
        along_ = h_function(0.75, 0), across_ = h_function(0.375, std::sqrt(0.5));
        const double l1 = moment(along_, 1), r1 = moment(across_, 1), r2 = moment(across_, 2);
        // c = cos x, q = sqrt 2 sin x: sqrt 2 l1 sin x + r1 cos x = what is left of the flux
        const double first = std::sqrt(2) * l1, rest = 0.5 / kScale - r2;
        const double x = std::atan2(first, r1) - std::acos(rest / std::hypot(first, r1));
        c_ = std::cos(x), q_ = std::sqrt(2) * std::sin(x);
    }
    double along(double mu) const { return kScale * q_ * at(along_, mu); }  // the normal, as projected
    double across(double mu) const { return kScale * (mu + c_) * at(across_, mu); }

private:
    static constexpr double kScale = 0.26516504294495535;  // 3/(8 sqrt 2)
    struct HFunction {
        double constant, scale;  // 1/H = constant + integral of mu' psi(mu') H(mu')/(mu + mu'), psi = scale (1 - mu^2)
        std::vector<double> value;  // at mu_
    };
    double at(const HFunction& h, double mu) const {
        double sum = h.constant;
        for (std::size_t i = 0; i < mu_.size(); ++i)
            sum += weight_[i] * mu_[i] * h.scale * (1 - mu_[i] * mu_[i]) * h.value[i] / (mu + mu_[i]);
        return 1 / sum;
    }
    HFunction h_function(double scale, double constant) const {
        constexpr int kRounds = 60;  // each leaves less than half of the error
        HFunction h{constant, scale, std::vector<double>(mu_.size(), 1.0)};
        for (int round = 0; round < kRounds; ++round) {
            std::vector<double> next;
            for (std::size_t i = 0; i < mu_.size(); ++i) next.push_back(0.5 * (h.value[i] + at(h, mu_[i])));
            h.value = next;
        }
        return h;
    }
    double moment(const HFunction& h, int power) const {
        double sum = 0;
        for (std::size_t i = 0; i < mu_.size(); ++i) sum += weight_[i] * h.value[i] * std::pow(mu_[i], power);
        return sum;
    }

    std::vector<double> mu_, weight_;
    HFunction along_, across_;
    double c_ = 0, q_ = 0;
};

const ElectronAtmosphere& electron_atmosphere() {
    static const ElectronAtmosphere atmosphere;
    return atmosphere;
}

double scattered_light(double mu) { return electron_atmosphere().along(mu) + electron_atmosphere().across(mu); }

}  // namespace

double scattered_fraction(double cosine) {
    const double along = electron_atmosphere().along(cosine), across = electron_atmosphere().across(cosine);
    return (across - along) / (across + along);
}

DiscLight::DiscLight(const Metric& metric, const DiscSpec& disc, const LightSpec& light)
    : metric_(metric), disc_(disc), light_(light), sense_(metric.sense(disc.sense)) {
    const auto hottest_is = [&](double temperature_K) {
        disc_.temperature_K = temperature_K;
        luminance_ = std::exp2(log2_brightness(temperature_K, light.bolometric));
    };
    hottest_is(disc.temperature_K);
    const double horizon = metric.horizon_radius().value_or(0.0);
    if (horizon == 0.0) {
        tabulate_emissivity();
        return;
    }
    // The least energy of all circles: Boost's Brent gives half of the digits, a bisection of its slope the rest.
    const auto slope = [&](double r) { return derivative(circles(r), &Circle::energy, r, apart(r)); };
    double low = metric.within_last_circle(), high = metric.beyond_last_circle();
    const auto energy_or_more = [&](double r) {
        const double e = circle(r).energy;
        return std::isfinite(e) ? e : 2.0;
    };
    isco_ = boost::math::tools::brent_find_minima(energy_or_more, low, high, 26).first;
    low = std::max(isco_ * (1 - 1e-3), low), high = isco_ * (1 + 1e-3);
    for (int i = 0; i < 45; ++i) (slope(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
    isco_ = 0.5 * (low + high);
    high = std::min(5 * isco_, metric.beyond_last_circle());
    hottest_ = boost::math::tools::brent_find_minima([&](double r) { return -flux(r); }, isco_, high, 30).first;
    const double peak = flux(hottest_);
    if (disc.accretion) hottest_is(accretion_temperature_K(*disc.accretion, peak));
    if (disc.emissivity.by != Emissivity::kAccretion)
        tabulate_emissivity();
    else if (disc.outer > isco_)
        tabulate_heat(disc.outer, peak);
}

// By steps of ln r from rim to rim.
void DiscLight::tabulate_emissivity() {
    if (disc_.emissivity.by == Emissivity::kAccretion) return;
    constexpr int kSteps = 4000;
    heated_ = std::max(disc_.inner, metric_.horizon_radius().value_or(0.0) * (1 + 1e-5));
    if (!(disc_.outer > heated_)) return;
    step_ = std::log(disc_.outer / heated_) / kSteps;
    std::vector<double> radii;
    for (int i = 0; i <= kSteps; ++i) radii.push_back(heated_ * std::exp(step_ * i));
    heat_ = emissivity_of(metric_, *this, disc_.emissivity, radii);
    const double most =
        std::max(*std::ranges::max_element(heat_), largest_at_kinks(disc_.emissivity, heated_, disc_.outer));
    for (double& value : heat_) value = most > 0 ? value / most : 0;
}

// Each ring adds to what those within it gained, over its width by the cubic through four: off by 11/720 step^4 of that, below 1e-11.
void DiscLight::tabulate_heat(double outer, double peak) {
    constexpr std::size_t kSteps = 4000;
    heated_ = isco_, step_ = std::log(outer / isco_) / kSteps;
    const auto radius = [&](std::size_t i) { return isco_ * std::exp(step_ * (static_cast<double>(i) - 1)); };
    std::vector<Ring> rings(kSteps + 3);  // one within the last circle, one beyond the disc
    tbb::parallel_for(std::size_t{0}, rings.size(), [&](std::size_t i) { rings[i] = ring(radius(i)); });
    const auto gained = [&](std::size_t i) { return rings[i].gained * radius(i); };  // by ln r
    heat_.assign(kSteps + 1, 0.0);
    double sum = 0;
    for (std::size_t i = 1; i <= kSteps; ++i) {
        sum += step_ / 24 * (13 * (gained(i) + gained(i + 1)) - (gained(i - 1) + gained(i + 2)));
        heat_[i] = rings[i + 1].shed(sum, radius(i + 1)) / peak;
    }
}

double DiscLight::heat(double r) const {
    if (heat_.empty() || !(r > heated_)) return 0.0;
    const double x = std::log(r / heated_) / step_;
    const int last = static_cast<int>(heat_.size()) - 1, i = std::clamp(static_cast<int>(x) - 1, 0, last - 3);
    const double f = x - i, *h = heat_.data() + i;  // cubic through four
    return std::max(-h[0] * (f - 1) * (f - 2) * (f - 3) / 6 + h[1] * f * (f - 2) * (f - 3) / 2 -
                        h[2] * f * (f - 1) * (f - 3) / 2 + h[3] * f * (f - 1) * (f - 2) / 6,
                    0.0);
}

DiscLight::Circle DiscLight::circle(double r) const {
    const auto near = nearby<EquatorialMetric>([this](double at) { return metric_.equator(at); }, r);
    const EquatorialMetric& g = near[kBeside];
    const double tt = derivative(near, &EquatorialMetric::g_tt, r), tp = derivative(near, &EquatorialMetric::g_tphi, r),
                 pp = derivative(near, &EquatorialMetric::g_phiphi, r);
    Circle c;
    c.omega = (sense_ * std::sqrt(std::max(tp * tp - tt * pp, 0.0)) - tp) / pp;
    c.u_t = 1 / std::sqrt(-g.g_tt - c.omega * (2 * g.g_tphi + g.g_phiphi * c.omega));
    c.energy = -(g.g_tt + g.g_tphi * c.omega) * c.u_t;
    c.momentum = (g.g_tphi + g.g_phiphi * c.omega) * c.u_t;
    return c;
}

double DiscLight::apart(double r) const {
    return std::min(kApart, kApartOfWay * (1 - metric_.horizon_radius().value_or(0.0) / r));
}

DiscLight::Circles DiscLight::circles(double r) const {
    return nearby<Circle>([this](double at) { return circle(at); }, r, apart(r));
}

DiscLight::Ring DiscLight::ring(double r) const {
    const Circles near = circles(r);
    const Circle& c = near[kBeside];
    const double gain = c.energy - c.omega * c.momentum;
    return {gain * derivative(near, &Circle::momentum, r, apart(r)), gain,
            derivative(near, &Circle::omega, r, apart(r))};
}

double DiscLight::Ring::shed(double sum, double r) const { return -omega_slope * sum / (4 * M_PI * r * gain * gain); }

double DiscLight::flux(double r) const {
    if (!(r > isco_) || isco_ == 0.0) return 0.0;
    const auto gained = [&](double at) { return ring(at).gained; };
    return ring(r).shed(boost::math::quadrature::gauss_kronrod<double, 31>::integrate(gained, isco_, r, 4, 1e-9), r);
}

// Within the last circle matter falls with its constants. By who has no angular momentum, N^2 = -1/g^tt and
// omega = -g_tphi/g_phiphi:  -N^2 (p . u) = (E - omega L)(1 - omega l_z) - N^2 L l_z/g_phiphi + climb fall,
// fall^2 = (E - omega L)^2 - N^2 (1 + L^2/g_phiphi).
double DiscLight::g_infinity(const PhotonAtDisc& photon) const {
    if (leans()) {
        const double rate = metric_.leaning_rate(photon.r, sense_, disc_.lean.tilt);
        return 1 / (metric_.leaning_u_t(photon.r, rate, disc_.lean.tilt, photon.cosine) * (1 - rate * photon.l_z));
    }
    if (photon.r >= isco_) {
        const Circle c = circle(photon.r);
        return 1 / (c.u_t * (1 - c.omega * photon.l_z));
    }
    const EquatorialMetric g = metric_.equator(photon.r);
    const Circle last = circle(isco_);
    const double n2 = g.lapse2(), omega = -g.g_tphi / g.g_phiphi, l = last.momentum, e = last.energy - omega * l;
    const double fall = std::sqrt(std::max(e * e - n2 * (1 + l * l / g.g_phiphi), 0.0));
    return n2 / (e * (1 - omega * photon.l_z) - n2 * l * photon.l_z / g.g_phiphi + photon.climb * fall);
}

// As in g_infinity; with D = N^2 g_phiphi, u^t = (E g_phiphi + L g_tphi)/D, u^phi = -(E g_tphi + L g_tt)/D, u^r = -fall/(N sqrt(g_rr)).
DiscLight::Velocity DiscLight::velocity(double r) const {
    if (!light_.doppler) return {1 / metric_.rest_lapse(r), 0, 0};
    if (r >= isco_) return circling(r);
    const EquatorialMetric g = metric_.equator(r);
    const Circle last = circle(isco_);
    const double n2 = g.lapse2(), e = last.energy + g.g_tphi / g.g_phiphi * last.momentum;
    const double fall = std::sqrt(std::max(e * e - n2 * (1 + last.momentum * last.momentum / g.g_phiphi), 0.0));
    const double d = n2 * g.g_phiphi;
    return {(last.energy * g.g_phiphi + last.momentum * g.g_tphi) / d, -fall / std::sqrt(n2 * g.g_rr),
            -(last.energy * g.g_tphi + last.momentum * g.g_tt) / d};
}

DiscLight::Velocity DiscLight::circling(double r) const {
    const Circle c = circle(r);
    return {c.u_t, 0, c.u_t * c.omega};
}

Shift DiscLight::shift(const PhotonAtDisc& photon) const {
    const double rest = metric_.rest_lapse(photon.r);  // of matter at rest there
    return {rest, g_infinity(met(photon)) / rest};
}

// A straight ray that comes by a direction of sine L/r is what a geodesic of L/lapse is to matter at rest there.
PhotonAtDisc DiscLight::met(const PhotonAtDisc& photon) const {
    return {photon.r, light_.lensing ? photon.l_z : photon.l_z / metric_.rest_lapse(photon.r), photon.climb,
            photon.cosine, photon.across};
}

// By its direction to who has no angular momentum: radial part climb/(1 - omega l_z), azimuthal N l_z/(sqrt(g_phiphi)(1 - omega l_z)),
// the rest along the normal. Matter sees that part of the momentum unchanged, and the frequency as Doppler's law has it between both.
double DiscLight::cosine(const PhotonAtDisc& photon) const {
    const PhotonAtDisc seen = met(photon);
    if (leans()) return std::clamp(seen.across * g_infinity(seen), 0.0, 1.0);
    const EquatorialMetric g = metric_.equator(seen.r);
    const double n2 = g.lapse2(), share = 1 + g.g_tphi / g.g_phiphi * seen.l_z, outward = seen.climb / share,
                 around2 = n2 * seen.l_z * seen.l_z / (g.g_phiphi * share * share);
    const double along = std::sqrt(std::max((1 - outward) * (1 + outward) - around2, 0.0));
    const double doppler = light_.doppler ? g_infinity(seen) * share / std::sqrt(n2) : 1;
    return std::clamp(along * doppler, 0.0, 1.0);
}

Vec3 DiscLight::colour(const PhotonAtDisc& photon, double g) const {
    const double share = heat(photon.r);
    if (!(share > 0)) return {0, 0, 0};
    const double temperature = disc_.temperature_K * std::pow(share, 0.25);
    double slant = 1;
    if (disc_.effects.limb_darkening) slant *= scattered_light(cosine(photon));
    return slant / luminance_ * seen_black_body(temperature, g, light_);
}

}  // namespace nullscope::reference
