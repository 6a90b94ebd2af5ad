#include "gradient/disc_glow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gradient/formula_number.h"
#include "light/black_body.h"

namespace nullscope {
namespace {

constexpr double kDark = 1e-30;  // of the largest emissivity
constexpr double kKink = 1.0;    // change of a table's power at a row, from which on the row is a mark

Shade own(double value, LightSeed seed) { return Shade::variable(value, static_cast<std::size_t>(seed)); }

// sigma T^4 = flux Mdot c^2/r_s^2, in T^4. Eddington's luminosity of one solar mass, and its r_s in m.
Number accretion_temperature4(const AccretionSpec& accretion, const Number& flux) {
    constexpr double kEddington_W = 1.25707e31, kSun_m = 2953.250077, kStefan_W_m2_K4 = 5.670374419e-8,
                     kEfficiency = 0.1;
    const double heat_W = accretion.rate_eddington * accretion.mass_suns * kEddington_W / kEfficiency,
                 r_s = accretion.mass_suns * kSun_m;
    return heat_W / (r_s * r_s * kStefan_W_m2_K4) * flux;
}

Shade root4(const Shade& x) { return sqrt(sqrt(x)); }

Error no_light(const char* key, const std::string& what, const char* allowed) {
    return bad_key(key, what + ": no derivatives of its light", allowed);
}

Status check_disc_light(const Scene& scene) {
    if (!scene.disc) return no_light("disc", "no disc", "a [disc] with emission = \"thermal\"");
    const DiscSpec& disc = *scene.disc;
    if (disc.emission != DiscEmission::kThermal) return no_light("disc.emission", "image", "thermal");
    const TextureKind texture = disc.material.texture;
    // Without a picture of its own its light is even.
    const bool even = texture == TextureKind::kImage && disc.image.empty();
    if (!even && texture != TextureKind::kPlain && texture != TextureKind::kGas && texture != TextureKind::kFormula)
        return no_light("disc.texture", texture_name(texture), "plain, gas (which counts as its mean), formula");
    if (texture == TextureKind::kFormula && disc.flow != DiscFlowKind::kStill)
        return no_light("disc.flow", "kepler", "still, with texture = \"formula\"");
    if (disc.emissivity.by == Emissivity::kLamp)
        return no_light("disc.emissivity", "a lamp", "accretion, power-law, table");
    if (disc.effects.limb_darkening) return no_light("disc.limb_darkening", "on", "off");
    if (disc.warp.there()) return no_light("disc.warp_radii", "a disc that is warped or has gaps", "a flat one");
    if (!scene.spots.empty()) return no_light("spot", "hot spots", "none");
    if (scene.medium || !scene.bodies.empty())
        return no_light(scene.medium ? "medium" : "body", "matter or bodies before the disc", "none");
    return Done{};
}

}  // namespace

Shade lifted(const Number& number) {
    Shade x(number.value);
    std::ranges::copy(number.d, x.d.begin());
    return x;
}

double sense_of(OrbitSense sense, const Flow& flow) {
    if (sense == OrbitSense::kEastward || sense == OrbitSense::kWestward)
        return sense == OrbitSense::kEastward ? 1 : -1;
    return (sense == OrbitSense::kPrograde) == (flow.spin().value >= 0) ? 1 : -1;
}

DiscGlow::DiscGlow(const Scene& scene, const Flow& flow, double sense)
    : spec_(*scene.disc), light_(scene.light), flow_(flow), motion_(flow, sense, spec_.lean) {}

Result<std::unique_ptr<DiscGlow>> DiscGlow::make(const Scene& scene, const Flow& flow) {
    TRY(known, check_disc_light(scene));
    std::unique_ptr<DiscGlow> glow(new DiscGlow(scene, flow, sense_of(scene.disc->sense, flow)));
    TRY(ready, glow->prepare());
    return glow;
}

Status DiscGlow::prepare() {
    const bool accretes = spec_.emissivity.by == Emissivity::kAccretion;
    if (accretes && !flow_.has_horizon())
        return no_light("disc.emissivity", "accretion without a horizon", "power-law");
    if (accretes || spec_.accretion) accretion_.emplace(motion_, spec_.outer);
    temperature_ = own(spec_.temperature_K, kSeedTemperature);
    if (spec_.accretion) temperature_ = root4(lifted(accretion_temperature4(*spec_.accretion, accretion_->peak())));
    unit_ = brightness(temperature_);
    if (spec_.emissivity.by == Emissivity::kTable) {
        TRY(rows, load_emissivity(spec_.emissivity.file));
        rows_ = std::move(*rows);
    }
    if (accretes) {
        most_ = lifted(accretion_->peak());
    } else {
        std::vector<Shade> light = {law(own(spec_.inner, kSeedInner)), law(own(spec_.outer, kSeedOuter))};
        for (const LawChange& change : law_changes()) light.push_back(law(Shade(change.r)));
        most_ = *std::ranges::max_element(light, {}, [](const Shade& shade) { return shade.value; });
        if (!(most_.value > 0)) return no_light("disc.emissivity", "none between the rims", "a table of these radii");
    }
    if (spec_.material.texture != TextureKind::kFormula) return Done{};
    TRY(formula, expr::Formula::parse(spec_.material.formula, {"u", "v", "x", "y", "z"}));
    if (!has_number(*formula)) return no_light("disc.formula", "noise", "a formula without noise()");
    formula_ = std::move(*formula);
    return Done{};
}

std::vector<LightMark> DiscGlow::marks() const {
    const Shade inner = own(spec_.inner, kSeedInner), outer = own(spec_.outer, kSeedOuter);
    std::vector<LightMark> marks = {inner, outer};
    if (spec_.edge > 0) {
        const Shade soft = spec_.edge * (outer - inner);
        marks.push_back(inner + soft), marks.push_back(outer - soft);
    }
    const Number& last = motion_.innermost();
    if (last.value > spec_.inner && last.value < spec_.outer) marks.push_back(lifted(last));
    for (const LawChange& change : law_changes())
        if (change.power > kKink) marks.emplace_back(change.r);
    std::ranges::sort(marks, {}, [](const LightMark& mark) { return mark.value; });
    return marks;
}

std::vector<DiscGlow::LawChange> DiscGlow::law_changes() const {
    std::vector<LawChange> changes;
    if (spec_.emissivity.by == Emissivity::kPowerLaw)
        for (const double r : spec_.emissivity.breaks) changes.push_back({r, HUGE_VAL});
    if (rows_) {
        double before = HUGE_VAL;
        for (auto row = rows_->begin(); row != rows_->end(); ++row) {
            const auto next = row + 1;
            const double power =
                next == rows_->end() ? -HUGE_VAL : std::log(next->value / row->value) / std::log(next->r / row->r);
            changes.push_back({row->r, std::fabs(power - before)});
            before = power;
        }
    }
    std::erase_if(changes,
                  [this](const LawChange& change) { return !(change.r > spec_.inner && change.r < spec_.outer); });
    return changes;
}

Shade DiscGlow::law(const Shade& r) const { return rows_ ? between_rows(r) : power_law(r); }

// A power of the radius from row to row.
Shade DiscGlow::between_rows(const Shade& r) const {
    if (!(r.value >= rows_->front().r && r.value <= rows_->back().r)) return Shade(0.0);
    const auto last = rows_->end() - 1;
    const auto after = std::min(std::ranges::upper_bound(*rows_, r.value, {}, &EmissivityRow::r), last);
    const EmissivityRow &a = *(after - 1), &b = *after;
    return a.value * exp(std::log(b.value / a.value) / std::log(b.r / a.r) * log(r / Shade(a.r)));
}

// r^-q from piece to piece.
Shade DiscGlow::power_law(const Shade& r) const {
    const EmissivitySpec& law = spec_.emissivity;
    const double q[] = {law.powers.x, law.powers.y, law.powers.z};
    Shade ln = -(own(q[0], kSeedPowers) * log(r));
    for (std::size_t i = 0; i < law.breaks.size(); ++i)
        if (r.value > law.breaks[i]) ln = ln - (q[i + 1] - q[i]) * log(r / Shade(law.breaks[i]));
    return exp(ln);
}

Shade DiscGlow::heat(const Number& r) const {
    const bool accretes = spec_.emissivity.by == Emissivity::kAccretion;
    return (accretes ? lifted(accretion_->flux(r)) : law(lifted(r))) / most_;
}

Shade DiscGlow::within_rims(const Shade& r) const {
    if (!(spec_.edge > 0)) return Shade(1.0);
    const Shade inner = own(spec_.inner, kSeedInner), outer = own(spec_.outer, kSeedOuter);
    const Shade from_inner = r - inner, from_outer = outer - r;
    const Shade depth = (from_inner.value < from_outer.value ? from_inner : from_outer) / (outer - inner);
    return formula_number::smooth_step(Shade(0.0), Shade(spec_.edge), depth);
}

Colour DiscGlow::pattern(const Shade& r, const Shade& azimuth) const {
    const Vec3 &first = spec_.material.colour, &second = spec_.material.second_colour;
    if (spec_.material.texture == TextureKind::kImage) return {Shade(1.0), Shade(1.0), Shade(1.0)};
    if (!formula_) return {Shade(first.x), Shade(first.y), Shade(first.z)};
    const Shade inner = own(spec_.inner, kSeedInner), outer = own(spec_.outer, kSeedOuter);
    Shade turned = azimuth - spec_.rotation;
    turned.value = std::remainder(turned.value, 2 * M_PI);
    const Shade variables[] = {0.5 + turned / (2 * M_PI), (r - inner) / (outer - inner), r * cos(azimuth),
                               r * sin(azimuth), Shade(0.0)};
    const Shade share = formula_number::clamped(formula_number_of<Shade>(*formula_, variables), Shade(0.0), Shade(1.0));
    const auto mixed = [&](double a, double b) { return a * share + b * (1.0 - share); };
    return {mixed(first.x, second.x), mixed(first.y, second.y), mixed(first.z, second.z)};
}

// Its colour is that of one of g T, with luminance or power 1, into the gamut of the display by its way to white.
Colour DiscGlow::black_body(const Shade& temperature, const Shade& g) const {
    const Shade coloured = light_.shift ? g * temperature : temperature,
                bright = light_.beaming ? g * temperature : temperature;
    const BlackBodySlope seen = black_body_slope(coloured.value);
    if (!(seen.xyz.y > 0)) return {Shade(0.0), Shade(0.0), Shade(0.0)};
    const auto by_temperature = [&](double value, double slope) { return chained(coloured, value, slope); };
    const Shade y = by_temperature(seen.xyz.y, seen.slope.y), x = by_temperature(seen.xyz.x, seen.slope.x) / y,
                z = by_temperature(seen.xyz.z, seen.slope.z) / y;
    const Vec3 of_x = rec709_from_xyz({1, 0, 0}), of_y = rec709_from_xyz({0, 1, 0}), of_z = rec709_from_xyz({0, 0, 1});
    Colour hue = {of_x.x * x + of_y.x + of_z.x * z, of_x.y * x + of_y.y + of_z.y * z, of_x.z * x + of_y.z + of_z.z * z};
    const Shade least = *std::ranges::min_element(hue, {}, [](const Shade& part) { return part.value; });
    if (least.value < 0)
        for (Shade& part : hue) part = 1.0 + (part - 1.0) / (1.0 - least);
    const Shade light = brightness(bright);
    for (Shade& part : hue) part = light * part;
    return hue;
}

Shade DiscGlow::brightness(const Shade& temperature) const {
    if (light_.bolometric) return temperature * temperature * temperature * temperature;
    const BlackBodySlope light = black_body_slope(temperature.value);
    return chained(temperature, light.xyz.y, light.slope.y);
}

DiscGlow::Light DiscGlow::at(const Photon& photon, const RayGradient::Crossing& crossing, const Number& shift) const {
    const Shade r = lifted(crossing.r);
    Light light{{Shade(0.0), Shade(0.0), Shade(0.0)},
                spec_.opacity > 0 ? own(spec_.opacity, kSeedOpacity) : Shade(0.0),
                lifted(motion_.g(photon, crossing) * shift)};
    light.g.d[kSeedShift] += light.g.value;
    light.coverage = light.coverage * within_rims(r);
    const Shade share = heat(crossing.r);
    if (!(share.value > kDark)) return light;
    Shade bearing = lifted(crossing.bearing);
    bearing.d[kSeedTurn] = 1;
    const Colour seen = black_body(temperature_ * root4(share), light.g), own_colour = pattern(r, bearing);
    const Shade scale = own(spec_.brightness, kSeedBrightness) * light.coverage / unit_;
    for (std::size_t i = 0; i < 3; ++i) light.colour[i] = scale * own_colour[i] * seen[i];
    return light;
}

}  // namespace nullscope
