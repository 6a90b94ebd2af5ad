// Rays in a static spherical metric given by formulas, ds^2 = -A dt^2 + B dr^2 + R^2 dOmega^2. With P = R/r and the momentum J of the ray's plane:
//     U = (E^2 P^4/A - J^2 u^2 P^2)/B,  x = E P^2/sqrt(A B),  T' = sqrt(B/A)(x + w)/u^2,  x + w = J^2 u^2 P^2/(B (x - w)).
// dU/du = -r^2 dU/dr is a derivative too, taken in duals of duals.
#include "gradient/flow.h"
#include "spacetime/metric_formulas.h"

namespace nullscope {
namespace {

using Sloped = Dual<Number, 1>;          // by r
constexpr double kInnermostLook = 1e-3;  // r_s, where there is no horizon

class FormulaFlow final : public Flow {
public:
    FormulaFlow(MetricFormulas formulas, double end, bool has_horizon)
        : formulas_(std::move(formulas)), innermost_(1 / end), has_horizon_(has_horizon) {}

    Photon launch(const Launch& from, RayState& state) const override {
        const LaunchFrame at(from);
        const Number across = formulas_.areal_radius(at.r), lapse2 = formulas_.lapse2(at.r);
        const Number southward = across * at.view[1], eastward = across * at.view[2];
        Photon photon;
        photon.energy = sqrt(lapse2);
        photon.momentum = -(eastward * at.sine);
        photon.bent = southward * southward + eastward * eastward;
        const Number part = across / at.r;
        state = launched(at, -(part * part * at.view[0] / sqrt(formulas_.stretch2(at.r))), southward, eastward);
        return photon;
    }

    RayState slope(const Photon& photon, const RayState& s, bool leaves) const override {
        const Number &u = s[kU], &w = s[kW], r = 1.0 / u;
        Sloped at;
        at.value = r, at.d[0] = Number(1.0);
        const Place<Sloped> p(*this, at);
        RayState rate;
        rate[kU] = w;
        rate[kW] = 0.5 * (photon.bent * (p.second.d[0] - 2.0 * (u * p.second.value)) -
                          photon.energy * photon.energy * (r * r * p.first.d[0]));
        for (std::size_t i = 0; i < 3; ++i) {
            rate[kN + i] = s[kTurn + i];
            rate[kTurn + i] = -(photon.bent * s[kN + i]);
        }
        const Number x = photon.energy * p.part2.value / p.root.value;
        rate[kTime] = leaves ? photon.bent * p.part2.value / (p.root.value * (x - w))
                             : p.root.value / p.lapse2.value * (x + w) / (u * u);
        return rate;
    }

    Number radial(const Photon& photon, const Number& u) const override {
        const Place<Number> p(*this, 1.0 / u);
        return photon.energy * photon.energy * p.first - photon.bent * u * u * p.second;
    }
    double innermost() const override { return innermost_; }
    bool has_horizon() const override { return has_horizon_; }
    EquatorNumbers equator(const ThriceBent& r) const override {
        const ThriceBent across = formulas_.areal_radius(r);
        return {-formulas_.lapse2(r), ThriceBent(0.0), across * across};
    }
    PlaceNumbers place(const Number& r, const Number& cosine) const override {
        const Number across = formulas_.areal_radius(r), across2 = across * across;
        return {-formulas_.lapse2(r), Number(0.0), across2 * (1.0 - cosine * cosine), across2, formulas_.stretch2(r)};
    }

private:
    // Of r: U = E^2 first - J^2 u^2 second. Where B is 1/A and R is r these are 1 and A to the last digit, far out too.
    template <class Value>
    struct Place {
        Value lapse2, root{1.0}, part2{1.0}, first{1.0}, second;  // A, sqrt(A B), P^2
        Place(const FormulaFlow& flow, const Value& r) : lapse2(flow.formulas_.lapse2(r)) {
            if (flow.formulas_.tilted()) {
                const Value part = flow.formulas_.areal_radius(r) / r;
                part2 = part * part;
            }
            if (flow.formulas_.has_b()) root = sqrt(lapse2 * flow.formulas_.stretch2(r));
            first = part2 * part2 / (root * root), second = part2 * lapse2 / (root * root);
        }
    };
    MetricFormulas formulas_;
    double innermost_;
    bool has_horizon_;
};

}  // namespace

Result<std::unique_ptr<Flow>> make_formula_flow(const std::map<std::string, std::string>& formulas,
                                                std::optional<double> horizon) {
    TRY(parsed, MetricFormulas::parse(formulas));
    return std::unique_ptr<Flow>(
        std::make_unique<FormulaFlow>(std::move(*parsed), horizon.value_or(kInnermostLook), horizon.has_value()));
}

}  // namespace nullscope
