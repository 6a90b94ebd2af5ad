#include "gradient/matter_glow.h"

#include <algorithm>
#include <cmath>

#include "gradient/formula_number.h"
#include "gradient/matter_law.h"
#include "plan/medium.h"
#include "plan/medium_model.h"
#include "scene/known_object.h"

namespace nullscope {
namespace {

enum { kTemperature, kField, kDensity, kOutward, kSouth, kEast };  // of formulas_

Error no_matter(const char* key, const std::string& what, const char* allowed) {
    return bad_key(key, what + ": no derivatives of its flux", allowed);
}

Status check_matter(const Scene& scene, const Flow& flow) {
    const MediumSpec& medium = *scene.medium;
    if (medium.kind != MediumKind::kFlow && medium.kind != MediumKind::kFormula)
        return no_matter("medium.kind", std::string(model_of(medium).word), "flow or formula");
    if (medium.law() == MediumEmission::kBlackBody)
        return no_matter("medium.emission", "black-body", "power-law, synchrotron or bremsstrahlung");
    if (medium.has_electrons()) return no_matter("medium.electrons", "electrons that are not thermal", "thermal");
    if (has_polarised_medium(scene)) return no_matter("medium.polarisation", "polarised light", "off");
    if (medium.bands_GHz.size() > 1) return no_matter("medium.frequency", "several frequencies", "one");
    if (medium.kind == MediumKind::kFormula && medium.height < medium.outer)
        return no_matter("medium.height", "a slab within the sphere", "at least medium.outer");
    if (const char* key = medium_moves(medium)) return no_matter(key, "matter that changes with time", "without t");
    if (scene.disc) return no_matter("disc", "matter beside a disc", "one of them");
    if (!scene.bodies.empty() || !scene.caps.empty())
        return no_matter("medium", "matter beside bodies", "a scene without");
    if (!flow.has_horizon()) return no_matter("spacetime.metric", "matter without a horizon", "a hole");
    return Done{};
}

}  // namespace

// Boyer and Lindquist's place of a ray, and the metric there.
struct MatterGlow::Place {
    Number r, cosine, sine;
    Number x, y, z;
    PlaceNumbers g;
    Place(const Flow& flow, const RayState& s) : r(1.0 / s[kU]), cosine(s[kN + 2]) {
        constexpr double kNearAxis = 1e-18;  // of the sine's square, where there is no azimuth
        Number sine2 = s[kN] * s[kN] + s[kN + 1] * s[kN + 1];
        if (sine2.value < kNearAxis) sine2 = Number(kNearAxis);
        sine = sqrt(sine2);
        const Number c = cos(s[kDragged]), i = sin(s[kDragged]);
        x = r * (c * s[kN] - i * s[kN + 1]), y = r * (i * s[kN] + c * s[kN + 1]), z = r * cosine;
        x.d[kSeedMatterTurn] += y.value, y.d[kSeedMatterTurn] -= x.value;
        g = flow.place(r, cosine);
    }
};

MatterGlow::MatterGlow(const Scene& scene, const Flow& flow)
    : spec_(*scene.medium),
      light_(scene.light),
      flow_(flow),
      length_cm_(100 * schwarzschild_radius_m(scene.object.mass().value_or(0.0))),
      unit_(medium_light_cgs(spec_.frequency_GHz)),
      nearest_(1 / flow.innermost() + kMediumAboveHorizon),
      farthest_(medium_farthest(spec_)) {}

Result<std::unique_ptr<MatterGlow>> MatterGlow::make(const Scene& scene, const Flow& flow) {
    TRY(known, check_matter(scene, flow));
    std::unique_ptr<MatterGlow> glow(new MatterGlow(scene, flow));
    TRY(ready, glow->prepare());
    return glow;
}

Status MatterGlow::prepare() {
    const MediumFormulas& f = spec_.formulas;
    std::vector<const std::string*> texts = {&f.temperature, &f.field};
    if (spec_.kind == MediumKind::kFormula) texts.insert(texts.end(), {&f.density, &f.outward, &f.south, &f.east});
    for (const std::string* text : texts) {
        TRY(formula, expr::Formula::parse(*text, medium_variables()));
        if (!has_number(*formula)) return no_matter("medium", "noise in " + *text, "formulas without noise()");
        formulas_.push_back(std::move(*formula));
    }
    if (spec_.kind == MediumKind::kFlow) scale_ = 1 / std::max(spec_.flow.flattening, 1.0);
    return Done{};
}

Number MatterGlow::formula(const expr::Formula& formula, const Place& place) const {
    const Number variables[] = {place.x, place.y, place.z, place.r, Number(0.0)};
    return formula_number_of<Number>(formula, variables);
}

// u_mu = u_t (-1, 0, 0, l) up to a factor, of the flow: u.u = -1.
std::optional<Triple> MatterGlow::velocity(const Place& place) const {
    const auto still = [](const Number& along) { return Triple{Number(0.0), Number(0.0), along}; };
    if (spec_.kind == MediumKind::kFlow) {
        constexpr double kMass = 0.5;
        const PlaceNumbers& g = place.g;
        const Number around = place.r * place.sine / kMass, root = sqrt(around);
        const Number l = kMass * spec_.flow.momentum * (around * root / (1.0 + around));
        const Number left = g.phiphi + l * (2.0 * g.tphi + l * g.tt);
        if (!(left.value > 0)) return std::nullopt;
        return still(l * sqrt((g.tphi * g.tphi - g.tt * g.phiphi) / (left * g.phiphi)));
    }
    Triple u;
    for (std::size_t i = 0; i < 3; ++i)
        u[i] = formula_number::clamped(formula(formulas_[kOutward + i], place), Number(-kFastestMatter),
                                       Number(kFastestMatter));
    return u;
}

std::optional<MatterGlow::Matter> MatterGlow::matter(const Place& place) const {
    const Number& r = place.r;
    Number density;
    switch (spec_.kind) {
        case MediumKind::kFlow: {
            const Number height = spec_.flow.flattening * place.cosine, x = (1 / spec_.flow.radius) * r;
            density = exp(-0.5 * (x * x + height * height));
            break;
        }
        case MediumKind::kFormula: density = formula(formulas_[kDensity], place); break;
        default: return std::nullopt;
    }
    if (!(density.value > 0)) return std::nullopt;
    const auto u = velocity(place);
    if (!u) return std::nullopt;
    Matter matter{spec_.density_scale * density, Number(0.0), Number(0.0), *u};
    if (spec_.warm()) matter.temperature = formula(formulas_[kTemperature], place);
    if (spec_.law_row().field) matter.field = formula(formulas_[kField], place);
    return matter;
}

// For who has no angular momentum: the light's energy and its momenta along the axes, dr = w r^2 dlambda and dcos(theta) = -n_z' dlambda of it as it runs.
MatterGlow::Seen MatterGlow::seen(const Photon& photon, const RayState& s, const Place& place, const Triple& u) const {
    const PlaceNumbers& g = place.g;
    const Number omega = -(g.tphi / g.phiphi), lapse = sqrt(-(g.tt + omega * g.tphi));
    const Number energy = (photon.energy - omega * photon.momentum) / lapse;
    const Triple k = {s[kW] * place.r * place.r * sqrt(g.rr) / g.thetatheta,
                      s[kTurn + 2] / (place.sine * sqrt(g.thetatheta)), photon.momentum / sqrt(g.phiphi)};
    const Number gamma = sqrt(1.0 + dot(u, u)), along = dot(u, k);
    Seen seen{gamma * energy - along, Number(1.0)};
    if (spec_.field_direction == FieldDirection::kIsotropic || !spec_.law_row().field) return seen;
    // The field's direction, boosted with the matter.
    const Vec3 way = field_way_of(spec_);
    const Triple b = {Number(way.x), Number(way.y), Number(way.z)};
    const Number moved = dot(u, b);
    const Number cosine = (dot(b, k) - moved * energy + moved * along / (1.0 + gamma)) / seen.frequency;
    const Number sine2 = 1.0 - cosine * cosine;
    seen.sine = sine2.value > 0 ? sqrt(sine2) : Number(0.0);
    return seen;
}

// Emissivity and absorptivity where the matter rests, cgs.
MatterGlow::Rates MatterGlow::coefficients(const Matter& matter, const Number& nu, const Number& sine) const {
    Number emitted;
    if (spec_.law() == MediumEmission::kPowerLaw) {
        constexpr double kReference = 230e9;
        const Number along = spec_.emissivity * matter.density, x = (1 / kReference) * nu;
        return {along * matter_law::power(x, -spec_.spectral_index),
                spec_.absorption > 0 ? spec_.absorption * (along * matter_law::power(x, -2.5 - spec_.spectral_index))
                                     : Number(0.0)};
    }
    if (spec_.law() == MediumEmission::kBremsstrahlung)
        emitted = matter_law::bremsstrahlung(matter.density, matter.temperature, nu);
    else if (spec_.field_direction == FieldDirection::kIsotropic)
        emitted = matter_law::synchrotron_mean(matter.density, matter.temperature, matter.field, nu);
    else
        emitted = matter_law::synchrotron_at(matter.density, matter.temperature, matter.field, sine, nu);
    if (!(emitted.value > 0)) return {Number(0.0), Number(0.0)};
    return {emitted, emitted / matter_law::planck(matter.temperature, nu)};  // Kirchhoff's law
}

MatterGlow::Rates MatterGlow::at(const Photon& photon, const RayState& state, const Number& shift) const {
    const Place place(flow_, state);
    const auto there = matter(place);
    if (!there) return {Number(0.0), Number(0.0)};
    const Seen seen = this->seen(photon, state, place, there->velocity);
    const Number ratio = seen.frequency / shift;  // over the camera's frequency
    const Rates cgs = coefficients(*there, 1e9 * spec_.frequency_GHz * (light_.shift ? ratio : Number(1.0)), seen.sine);
    const Number way = length_cm_ * (seen.frequency * place.g.thetatheta);
    const Number beamed = light_.beaming ? 1.0 / (ratio * ratio * ratio) : Number(1.0);
    return {(1 / unit_) * (beamed * cgs.light * way), cgs.depth * way};
}

}  // namespace nullscope
