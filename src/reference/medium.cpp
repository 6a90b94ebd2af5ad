#include "reference/medium.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "reference/medium_grid.h"
#include "reference/noise_ring.h"

namespace nullscope::reference {
namespace {

constexpr double kPanel = 0.08;  // of the length over which matter changes: 1e-4 of the flux
constexpr int kDeepest = 24;     // halvings

// Clumps in the gas: a factor on its density, of mean 1. Octaves of rings of equal ln(rho), which are cones, turned with the height.
double clumps(const MediumSpec& spec, double rho, double heights, double azimuth, double age,
              const std::function<double(double)>& rate) {
    constexpr int kOctaves = 4;
    const double x = std::log(rho);
    double moved = x, density = 1;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double sign = octave % 2 == 0 ? 1 : -1, ring_step = 0.3 / (1 << octave), first = 0.37 * octave,
                     tilt = sign * 0.7 * std::pow(1.6, octave) * heights, row = moved / ring_step + first + tilt,
                     ring = std::floor(row), lean = sign * 0.35 / 8 * std::pow(0.8, octave) * heights;
        const auto noise_of = [&](double number) {
            const double middle = (number - first) * ring_step,
                         turns =
                             (azimuth + spec.gas.winding * (x - middle) - rate(std::exp(middle)) * age) / (2 * M_PI);
            return NoiseRing(static_cast<long long>(number), static_cast<unsigned>(octave)).noise(turns + lean);
        };
        const double n = NoiseRing::blend(noise_of(ring), noise_of(ring + 1), row - ring),
                     c = spec.gas.contrast * std::pow(0.82, octave);
        density *= (1 + c * n) * (1 + c * n) / (1 + c * c / 3);
        moved += 0.4 * ring_step * n;
    }
    return density;
}

// all_round: matter is the same at every azimuth, of which light has many next to a rotating horizon.
double apart(const Medium::Place& a, const Medium::Place& b, bool all_round) {
    const double across_a = a.r * std::sin(a.theta), across_b = b.r * std::sin(b.theta);
    const double turn = all_round ? 0 : b.phi - a.phi, x = across_a - across_b * std::cos(turn),
                 y = across_b * std::sin(turn), z = a.r * std::cos(a.theta) - b.r * std::cos(b.theta);
    return std::max(std::hypot(x, y, z), std::abs(a.r - b.r));
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
        const double z = std::abs(place.r * std::cos(place.theta)),
                     off = std::min(std::abs(place.r - spec_.outer), std::abs(z - spec_.height)),
                     outside = std::max(place.r - spec_.outer, z - spec_.height);
        double inner = kInner * spec_.outer / spec_.steps;
        // About the centre of flat space the swept angle is of little use.
        inner = std::min(inner, horizon_ > 0 ? kPanel * (place.r - horizon_) : kNearCentre * place.r);
        return outside > 0 ? std::max(outside, kEdge * spec_.outer)
                           : std::min(inner, std::max(off, kEdge * spec_.outer));
    }
    if (spec_.kind == MediumKind::kGas) {
        constexpr double kGasPanel = 0.05;  // of the scale height, where clumps are
        const double rho = place.r * std::sin(place.theta), z = std::abs(place.r * std::cos(place.theta)),
                     height = spec_.thickness * rho;
        const double off = (z - kGasHeights * height) / std::hypot(1.0, kGasHeights * spec_.thickness);
        return std::max(
            {kGasPanel * spec_.thickness * std::max(rho, spec_.inner), spec_.inner - rho, rho - spec_.outer, off});
    }
    double scale = std::min({spec_.radius, place.r, std::max(place.r - horizon_, kMediumAboveHorizon)});
    if (place.r > farthest_) scale = std::max(scale, (place.r - farthest_) / kPanel);
    if (spec_.flattening > 0) {
        const double thick = 1 / std::max(spec_.flattening, 1.0), off = std::abs(std::cos(place.theta));
        scale = std::min(scale, place.r * std::max(thick, (off - kFlowScales * thick) / kPanel));
    }
    return kPanel * scale;
}

void Medium::split(double from, const Place& begin, double to, const Place& end, int depth, const At& at,
                   const std::function<double(const Place&, double)>& way, std::vector<MediumNode>& nodes) const {
    const double middle = 0.5 * (from + to);
    const Place between = at(middle);
    const bool all_round = spec_.kind != MediumKind::kGas;
    const double length = apart(begin, between, all_round) + apart(between, end, all_round);
    // The horizon and the ends of matter by place are the same all round: azimuth counts by its formulas' own steps.
    const bool turns = spec_.by_place() && std::max({begin.r, between.r, end.r}) < 2 * spec_.outer &&
                       apart(begin, between, false) + apart(between, end, false) > spec_.outer / spec_.steps;
    if (std::min({begin.r, between.r, end.r}) > farthest_ && length < 2 * (between.r - farthest_)) return;
    if (depth < kDeepest && (turns || length > std::min({panel(begin), panel(between), panel(end)}))) {
        split(from, begin, middle, between, depth + 1, at, way, nodes);
        split(middle, between, to, end, depth + 1, at, way, nodes);
    } else if (between.r > nearest_ && between.r < farthest_) {
        MediumNode node{middle, between.r, between.theta, between.phi, between.delay, way(between, to - from)};
        if (spec_.by_place()) {  // central differences
            const double beside = 1e-3 * (to - from), length_beside = way(between, 2 * beside);
            const Place before = at(middle - beside), after = at(middle + beside);
            node.r_slope = (after.r - before.r) / length_beside;
            node.theta_slope = (after.theta - before.theta) / length_beside;
        }
        nodes.push_back(node);
    }
}

void Medium::add_nodes(double from, double to, const At& at, const std::function<double(const Place&, double)>& way,
                       std::vector<MediumNode>& nodes) const {
    if (to > from && std::isfinite(to)) split(from, at(from), to, at(to), 0, at, way, nodes);
}

Medium::Light Medium::at(const MediumNode& node, double energy, double momentum) const {
    if (spec_.by_place()) return by_place(node, energy, momentum);
    return spec_.kind == MediumKind::kGas ? gas(node, energy, momentum) : flow(node, energy, momentum);
}

MatterState Medium::formula(const MediumNode& node) const {
    const double across = node.r * std::sin(node.theta), z = node.r * std::cos(node.theta);
    const double at[] = {across * std::cos(node.phi), across * std::sin(node.phi), z, node.r, time_ - node.delay};
    const auto speed = [&](const expr::Formula& f) { return std::clamp(f.value(at), -kFastestMatter, kFastestMatter); };
    return {std::max(formulas_->density.value(at), 0.0),
            formulas_->temperature.value(at),
            formulas_->field.value(at),
            {},
            {speed(formulas_->outward), speed(formulas_->south), speed(formulas_->east)}};
}

Medium::Light Medium::by_place(const MediumNode& node, double energy, double momentum) const {
    const bool there = formulas_ || grid_;
    if (!there || node.r > spec_.outer || std::abs(node.r * std::cos(node.theta)) > spec_.height) return {{0, 0, 0}, 1};
    const MatterState matter =
        grid_ ? grid_matter(*grid_, spec_.density_scale, horizon_, node.r, node.theta, node.phi) : formula(node);
    constexpr double kAxis = 1e-9;  // rad, where there is no azimuth
    const PlaceMetric g = matter_.place(node.r, std::clamp(node.theta, kAxis, M_PI - kAxis));
    return emission_law_->at(matter, g, node, energy, momentum);
}

// Of matter on circles: u = u^t (1, 0, 0, Omega).
Medium::Light Medium::gas(const MediumNode& node, double energy, double momentum) const {
    const double rho = node.r * std::sin(node.theta), heights = node.r * std::cos(node.theta) / (spec_.thickness * rho);
    const double in = std::min(std::log(rho / spec_.inner), std::log(spec_.outer / rho)) / spec_.edge,
                 rim = std::clamp(in, 0.0, 1.0);
    if (rim == 0 || std::abs(heights) > kGasHeights) return {{0, 0, 0}, 1};
    const double age = spec_.flow == DiscFlowKind::kKepler ? time_ - node.delay : 0.0;
    const double density = rim * rim * (3 - 2 * rim) * std::exp(-0.5 * heights * heights) *
                           clumps(spec_, rho, heights, node.phi, age, [&](double r) { return rate_(r); });
    const PlaceMetric g = matter_.place(node.r, node.theta);
    const double omega = rate_(rho), u_t = 1 / std::sqrt(-(g.g_tt + omega * (2 * g.g_tphi + omega * g.g_phiphi))),
                 ratio = 1 / (u_t * (energy - momentum * omega));
    const double depth =
        density * spec_.optical_depth / (std::sqrt(2 * M_PI) * spec_.thickness * rho) * node.way / ratio;
    const double temperature = spec_.temperature_K * std::pow(spec_.inner / rho, 0.75);
    return black_body_light(spec_, light_, unit_light_, temperature, ratio, depth);
}

Medium::Light Medium::flow(const MediumNode& node, double energy, double momentum) const {
    const PlaceMetric g = matter_.place(node.r, node.theta);
    // u_mu = u_t (-1, 0, 0, l), l = l0 R^1.5/(1 + R) in M; from u.u = -1.
    const double around = node.r * std::sin(node.theta) / 0.5,
                 l = spec_.momentum * std::pow(around, 1.5) / (1 + around) * 0.5;
    const double det = g.g_tt * g.g_phiphi - g.g_tphi * g.g_tphi;
    const double up_tt = g.g_phiphi / det, up_tphi = -g.g_tphi / det, up_phiphi = g.g_tt / det;
    const double scale = 1 / std::sqrt(-(up_tt - 2 * up_tphi * l + up_phiphi * l * l));
    const double u_t = scale * (-up_tt + up_tphi * l), u_phi = scale * (-up_tphi + up_phiphi * l);
    const double ratio = 1 / (energy * u_t - momentum * u_phi);  // camera frequency over the matter's
    const double height = spec_.flattening * std::cos(node.theta), x = node.r / spec_.radius;
    const double density = std::exp(-0.5 * (x * x + height * height));
    const double nu = light_.shift ? 1 / ratio : 1.0, length = node.way / ratio;
    const double bright = light_.beaming ? std::pow(ratio, 3) : 1.0;
    const double emitted = bright * emission_ * density * std::pow(nu, -spec_.spectral_index) * length;
    const double depth = absorption_ * density * std::pow(nu, -2.5 - spec_.spectral_index) * length;
    return even_light(spec_, emitted, depth);
}

}  // namespace nullscope::reference
