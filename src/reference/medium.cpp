#include "reference/medium.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "reference/medium_grid.h"
#include "reference/noise_ring.h"

namespace nullscope::reference {
namespace {

constexpr double kMatterPanel = 0.08;   // of the length over which matter changes: 1e-4 of the flux
constexpr int kDeepestStep = 24;  // halvings

// Clumps in the gas: a factor on its density, of mean 1. Octaves of rings of equal ln(rho), which are cones, turned with the height.
double clumps(const MediumSpec& spec, double rho, double heights, double azimuth, double age,
              const std::function<double(double)>& rate) {
    constexpr int kOctaves = 4;
    const double x = std::log(rho);
    double moved = x, density = 1, steeper = 1, flatter = 1, contrast = spec.gas.contrast;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double sign = octave % 2 == 0 ? 1 : -1, ring_step = 0.3 / (1 << octave), first = 0.37 * octave,
                     tilt = sign * 0.7 * steeper * heights, row = moved / ring_step + first + tilt,
                     ring = std::floor(row), lean = sign * 0.35 / 8 * flatter * heights;
        const auto noise_of = [&](double number) {
            const double middle = (number - first) * ring_step, went = age != 0 ? rate(std::exp(middle)) * age : 0.0,
                         turns = (azimuth + spec.gas.winding * (x - middle) - went) / (2 * M_PI);
            return NoiseRing(static_cast<long long>(number), static_cast<unsigned>(octave)).noise(turns + lean);
        };
        const double n = NoiseRing::blend(noise_of(ring), noise_of(ring + 1), row - ring), c = contrast;
        density *= (1 + c * n) * (1 + c * n) / (1 + c * c / 3);
        moved += 0.4 * ring_step * n;
        steeper *= 1.6, flatter *= 0.8, contrast *= 0.82;
    }
    return density;
}

double off_axis(const Vec3& at) { return std::sqrt(at.x * at.x + at.y * at.y); }

// all_round: matter is the same at every azimuth, of which light has many next to a rotating horizon.
double apart(const Medium::Place& a, const Medium::Place& b, bool all_round) {
    const Vec3 from = a.flat(), to = b.flat();
    const double out = all_round ? off_axis(to) - off_axis(from) : 0, up = to.z - from.z;
    const double by_place = all_round ? std::sqrt(out * out + up * up) : std::sqrt(dot(to - from, to - from));
    return std::max(by_place, std::abs(a.r - b.r));
}

// In the middle of a width, by central differences.
Medium::Slopes slopes_between(const Medium::Place& middle, double along, double width, const Medium::Way& way) {
    const double beside = 1e-3 * width, parameter = way.affine(middle, 2 * beside);
    const Medium::Place before = way.at(along - beside), after = way.at(along + beside);
    const auto polar = [](const Medium::Place& p) {
        return std::atan2(std::hypot(p.direction.x, p.direction.y), p.direction.z);
    };
    return {(after.r - before.r) / parameter, (polar(after) - polar(before)) / parameter};
}

}  // namespace

Medium::Medium(const Scene& scene, const Metric& matter)
    : matter_(matter), spec_(*scene.medium), light_(scene.light), time_(scene.time), farthest_(medium_farthest(spec_)) {
    horizon_ = matter.horizon_radius().value_or(0.0);
    nearest_ = horizon_ + kMediumAboveHorizon;
    moves_ = medium_moves(spec_) != nullptr && light_.delay;
    if (spec_.by_place()) emission_law_.emplace(scene);
    if (spec_.kind == MediumKind::kGrid)
        if (const auto grid = load_medium_grid(spec_.file)) grid_ = *grid;  // scene files are checked
    if (spec_.kind == MediumKind::kFormula) {
        const MediumFormulas& f = spec_.formulas;
        const auto parsed = [](const std::string& text) {
            auto formula = expr::Formula::parse(text, medium_variables());
            return formula ? std::move(*formula) : *expr::Formula::parse("0", {});
        };
        formulas_ = Formulas{parsed(f.density), parsed(f.temperature), parsed(f.field),
                             parsed(f.outward), parsed(f.south),       parsed(f.east)};
    }
    if (spec_.by_place()) return;
    if (spec_.kind == MediumKind::kGas) {
        unit_light_ = unit_light_of(spec_, light_);
        rate_ = [&matter](double r) { return matter.kepler_rate(r); };
        return;
    }
    const FlowNumbers flow = flow_numbers(spec_, scene.object.mass().value_or(0.0));
    emission_ = flow.emission, absorption_ = flow.absorption;
}

double Medium::panel(const Place& place) const {
    if (spec_.by_place()) {
        constexpr double kInner = 0.5, kEdge = 1e-7,
                         kNearCentre = 0.02;  // of a sample of the shader, of the sphere at its edges, of r
        const double z = std::abs(place.flat().z),
                     off = std::min(std::abs(place.r - spec_.outer), std::abs(z - spec_.height)),
                     outside = std::max(place.r - spec_.outer, z - spec_.height);
        double inner = kInner * spec_.outer / spec_.steps;
        // About the centre of flat space the swept angle is of little use.
        inner = std::min(inner, horizon_ > 0 ? kMatterPanel * (place.r - horizon_) : kNearCentre * place.r);
        return outside > 0 ? std::max(outside, kEdge * spec_.outer)
                           : std::min(inner, std::max(off, kEdge * spec_.outer));
    }
    if (spec_.kind == MediumKind::kGas) {
        constexpr double kGasPanel = 0.05;  // of the scale height, where clumps are
        const Vec3 at = place.flat();
        const double rho = off_axis(at), z = std::abs(at.z), height = spec_.thickness * rho;
        const double off = (z - kGasHeights * height) / std::hypot(1.0, kGasHeights * spec_.thickness);
        return std::max(
            {kGasPanel * spec_.thickness * std::max(rho, spec_.inner), spec_.inner - rho, rho - spec_.outer, off});
    }
    double scale = std::min({spec_.radius, place.r, std::max(place.r - horizon_, kMediumAboveHorizon)});
    if (place.r > farthest_) scale = std::max(scale, (place.r - farthest_) / kMatterPanel);
    if (spec_.flattening > 0) {
        const double thick = 1 / std::max(spec_.flattening, 1.0), off = std::abs(place.direction.z);
        scale = std::min(scale, place.r * std::max(thick, (off - kFlowScales * thick) / kMatterPanel));
    }
    return kMatterPanel * scale;
}

Medium::Look Medium::look(double along, const Way& way) const {
    const Place place = way.at(along);
    return {along, place, panel(place)};
}

void Medium::split(const Look& begin, const Look& end, int depth, const Way& way,
                   std::vector<MediumNode>& nodes) const {
    const Look between = look(0.5 * (begin.along + end.along), way);
    const double r = between.place.r;
    const bool all_round = spec_.kind != MediumKind::kGas;
    const double length = apart(begin.place, between.place, all_round) + apart(between.place, end.place, all_round);
    if (std::min({begin.place.r, r, end.place.r}) > farthest_ && length < 2 * (r - farthest_)) return;
    // The horizon and the ends of matter by place are the same all round: azimuth counts by its formulas' own steps.
    const bool turns =
        spec_.by_place() && std::max({begin.place.r, r, end.place.r}) < 2 * spec_.outer &&
        apart(begin.place, between.place, false) + apart(between.place, end.place, false) > spec_.outer / spec_.steps;
    if (depth < kDeepestStep && (turns || length > std::min({begin.panel, between.panel, end.panel}))) {
        split(begin, between, depth + 1, way, nodes);
        split(between, end, depth + 1, way, nodes);
    } else if (r > nearest_ && r < farthest_) {
        const double width = end.along - begin.along;
        MediumNode node{between.along, r, between.place.direction, between.place.delay,
                        way.affine(between.place, width)};
        if (spec_.by_place()) {
            const Slopes slopes =
                between.place.slopes ? *between.place.slopes : slopes_between(between.place, between.along, width, way);
            node.r_slope = slopes.r, node.theta_slope = slopes.theta;
        }
        nodes.push_back(node);
    }
}

void Medium::add_nodes(double from, double to, const Way& way, std::vector<MediumNode>& nodes) const {
    if (to > from && std::isfinite(to)) split(look(from, way), look(to, way), 0, way, nodes);
}

Medium::Light Medium::at(const MediumNode& node, double energy, double momentum) const {
    if (spec_.by_place()) return by_place(node, energy, momentum);
    return spec_.kind == MediumKind::kGas ? gas(node, energy, momentum) : flow(node, energy, momentum);
}

MatterState Medium::formula(const MediumNode& node) const {
    const Vec3 place = node.r * node.direction;
    const double at[] = {place.x, place.y, place.z, node.r, time_ - node.delay};
    const auto speed = [&](const expr::Formula& f) { return std::clamp(f.value(at), -kFastestMatter, kFastestMatter); };
    return {std::max(formulas_->density.value(at), 0.0),
            formulas_->temperature.value(at),
            formulas_->field.value(at),
            {},
            {speed(formulas_->outward), speed(formulas_->south), speed(formulas_->east)}};
}

Medium::Light Medium::by_place(const MediumNode& node, double energy, double momentum) const {
    const bool there = formulas_ || grid_;
    if (!there || node.r > spec_.outer || std::abs(node.r * node.cosine()) > spec_.height) return {{0, 0, 0}, 1};
    const MatterState matter =
        grid_ ? grid_matter(*grid_, spec_.density_scale, horizon_, node.r, std::atan2(node.sine(), node.cosine()),
                            std::atan2(node.direction.y, node.direction.x))
              : formula(node);
    constexpr double kAxis = 1e-9;  // of the sine, where there is no azimuth
    const PlaceMetric g = matter_.place(node.r, std::max(node.sine(), kAxis), node.cosine());
    return emission_law_->at(matter, g, node, energy, momentum);
}

// Of matter on circles: u = u^t (1, 0, 0, Omega).
Medium::Light Medium::gas(const MediumNode& node, double energy, double momentum) const {
    const double sine = node.sine(), rho = node.r * sine, heights = node.r * node.cosine() / (spec_.thickness * rho);
    const double in = std::min(std::log(rho / spec_.inner), std::log(spec_.outer / rho)) / spec_.edge,
                 rim = std::clamp(in, 0.0, 1.0);
    if (rim == 0 || std::abs(heights) > kGasHeights) return {{0, 0, 0}, 1};
    const double age = spec_.flow == DiscFlowKind::kKepler ? time_ - node.delay : 0.0;
    const double density = rim * rim * (3 - 2 * rim) * std::exp(-0.5 * heights * heights) *
                           clumps(spec_, rho, heights, std::atan2(node.direction.y, node.direction.x), age, rate_);
    const PlaceMetric g = matter_.place(node.r, sine, node.cosine());
    const double omega = rate_(rho), u_t = 1 / std::sqrt(-(g.g_tt + omega * (2 * g.g_tphi + omega * g.g_phiphi))),
                 ratio = 1 / (u_t * (energy - momentum * omega));
    const double depth =
        density * spec_.optical_depth / (std::sqrt(2 * M_PI) * spec_.thickness * rho) * node.way / ratio;
    const double temperature = spec_.temperature_K * std::sqrt(spec_.inner / rho * std::sqrt(spec_.inner / rho));
    return black_body_light(spec_, light_, unit_light_, temperature, ratio, depth);
}

Medium::Light Medium::flow(const MediumNode& node, double energy, double momentum) const {
    const PlaceMetric g = matter_.place(node.r, node.sine(), node.cosine());
    // u_mu = u_t (-1, 0, 0, l), l = l0 R^1.5/(1 + R) in M; from u.u = -1.
    const double around = node.r * node.sine() / 0.5, l = spec_.momentum * std::pow(around, 1.5) / (1 + around) * 0.5;
    const double det = g.g_tt * g.g_phiphi - g.g_tphi * g.g_tphi;
    const double up_tt = g.g_phiphi / det, up_tphi = -g.g_tphi / det, up_phiphi = g.g_tt / det;
    const double scale = 1 / std::sqrt(-(up_tt - 2 * up_tphi * l + up_phiphi * l * l));
    const double u_t = scale * (-up_tt + up_tphi * l), u_phi = scale * (-up_tphi + up_phiphi * l);
    const double ratio = 1 / (energy * u_t - momentum * u_phi);  // camera frequency over the matter's
    const double height = spec_.flattening * node.cosine(), x = node.r / spec_.radius;
    const double density = std::exp(-0.5 * (x * x + height * height));
    const double nu = light_.shift ? 1 / ratio : 1.0, length = node.way / ratio;
    const double bright = light_.beaming ? std::pow(ratio, 3) : 1.0;
    const double emitted = bright * emission_ * density * std::pow(nu, -spec_.spectral_index) * length;
    const double depth = absorption_ * density * std::pow(nu, -2.5 - spec_.spectral_index) * length;
    return even_light(spec_, emitted, depth);
}

}  // namespace nullscope::reference
