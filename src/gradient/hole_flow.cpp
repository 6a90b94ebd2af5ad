// Rays about Kerr and Newman's hole and its limits, 2 M = 1: Delta = r^2 - r + a^2 + Q^2 = r^2 D(u), D = 1 - u + (a^2 + Q^2) u^2;
//     U = x^2 - u^2 D K,  x = E + (a^2 E - a L) u^2,  K = C - 2 a L E + a^2 E^2,
//     dragged' = -a (x/D - E),  T' = (1 + a^2 u^2)(x + w)/(D u^2) + a (L - a E sin^2 theta),
// where x + w = u^2 D K/(x - w).
#include "gradient/flow.h"

namespace nullscope {
namespace {

class HoleFlow final : public Flow {
public:
    HoleFlow(double mass, double spin, double charge)
        : mass2_(2 * mass),
          a_(0.5 * Number::variable(spin, kSeedSpin)),
          a2_(a_ * a_),
          charge2_(0.25 * (Number::variable(charge, kSeedCharge) * Number::variable(charge, kSeedCharge))),
          both2_(a2_ + charge2_) {}

    Photon launch(const Launch& from, RayState& state) const override {
        const LaunchFrame at(from);
        const Number across = at.r * at.r + a2_, cosine2 = at.cosine * at.cosine, sine2 = at.sine * at.sine;
        const Number sigma = at.r * at.r + a2_ * cosine2, delta = across - mass2_ * at.r + charge2_;
        const Number area = across * across - delta * a2_ * sine2;
        const Number l_over_sine = -(sqrt(area / sigma) * at.view[2]);  // the photon runs against the view
        const Number p_theta = sqrt(sigma) * at.view[1], rise = sqrt(sigma * delta) * at.view[0];
        Photon photon;
        photon.momentum = l_over_sine * at.sine;
        photon.energy = sqrt(delta * sigma / area) + a_ * (mass2_ * at.r - charge2_) / area * photon.momentum;
        const Number ae = a_ * photon.energy;
        photon.pull = ae * ae;
        photon.bent = p_theta * p_theta + l_over_sine * l_over_sine - photon.pull * cosine2;
        photon.bend = a_ * (ae - photon.momentum);
        photon.carter = photon.bent + ae * (ae - 2.0 * photon.momentum);
        photon.swept = a_ * ae;
        state = launched(at, -(rise / (at.r * at.r)), p_theta, -l_over_sine);
        return photon;
    }

    RayState slope(const Photon& photon, const RayState& s, bool leaves) const override {
        const Number &u = s[kU], &w = s[kW], &cosine = s[kN + 2];
        const Parts p(*this, photon, u);
        const Number pulled = photon.pull * cosine, turning = photon.bent + 2.0 * (pulled * cosine);
        RayState rate;
        rate[kU] = w;
        rate[kW] = u * (2.0 * (photon.bend * p.x) - photon.carter * (p.d + 0.5 * (u * p.d_slope)));
        for (std::size_t i = 0; i < 3; ++i) {
            rate[kN + i] = s[kTurn + i];
            rate[kTurn + i] = -(turning * s[kN + i]);
        }
        rate[kTurn + 2] = rate[kTurn + 2] + pulled;
        rate[kDragged] = -(a_ * (p.x / p.d - photon.energy));
        const Number round = 1.0 + a2_ * p.u2;
        const Number fall = leaves ? photon.carter / (p.x - w) : (p.x + w) / (p.d * p.u2);
        rate[kTime] = round * fall - photon.bend + photon.swept * (cosine * cosine);
        return rate;
    }

    Number radial(const Photon& photon, const Number& u) const override {
        const Parts p(*this, photon, u);
        return p.x * p.x - p.u2 * p.d * photon.carter;
    }
    double innermost() const override {
        const double root = mass2_ * mass2_ - 4 * both2_.value;
        return has_horizon() ? 2 / (mass2_ + std::sqrt(root)) : 1e3;
    }
    bool has_horizon() const override { return mass2_ != 0 && mass2_ * mass2_ >= 4 * both2_.value; }
    Number spin() const override { return a_; }
    // pull = 2 m(r)/r, 2 m(r) r = 2 M r - Q^2
    EquatorNumbers equator(const ThriceBent& r) const override {
        const ThriceBent a = bent(a_), pull = (mass2_ * r - bent(charge2_)) / (r * r);
        return {pull - 1.0, -(a * pull), r * r + a * a * (1.0 + pull)};
    }
    PlaceNumbers place(const Number& r, const Number& cosine) const override {
        const Number r2 = r * r, sine2 = 1.0 - cosine * cosine, sigma = r2 + a2_ * cosine * cosine;
        const Number pull = (mass2_ * r - charge2_) / sigma;
        return {pull - 1.0, -(a_ * pull * sine2), (r2 + a2_ + a2_ * sine2 * pull) * sine2, sigma,
                sigma / (r2 + a2_ - mass2_ * r + charge2_)};
    }

private:
    static ThriceBent bent(const Number& x) {
        ThriceBent constant;
        constant.value.value.value = x;
        return constant;
    }
    struct Parts {
        Number u2, d, d_slope, x;
        Parts(const HoleFlow& hole, const Photon& photon, const Number& u) : u2(u * u) {
            d_slope = 2.0 * (hole.both2_ * u) - hole.mass2_;
            d = 1.0 - hole.mass2_ * u + hole.both2_ * u2;
            x = photon.energy + photon.bend * u2;
        }
    };
    double mass2_;
    Number a_, a2_, charge2_, both2_;
};

}  // namespace

std::unique_ptr<Flow> make_hole_flow(double mass, double spin, double charge) {
    return std::make_unique<HoleFlow>(mass, spin, charge);
}

}  // namespace nullscope
