#include "reference/medium.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"

namespace nullscope::reference {
namespace {

constexpr double kPanel = 0.08;  // of the length over which matter changes: 1e-4 of the flux
constexpr int kDeepest = 24;     // halvings

double apart(const Medium::Place& a, const Medium::Place& b) {
    const double x = a.r * std::sin(a.theta) - b.r * std::sin(b.theta), z = a.r * std::cos(a.theta) - b.r * std::cos(b.theta);
    return std::max(std::hypot(x, z), std::abs(a.r - b.r));
}

}  // namespace

Medium::Medium(const Scene& scene, const Metric& matter)
    : matter_(matter), spec_(*scene.medium), light_(scene.light), farthest_(medium_farthest(spec_)) {
    horizon_ = matter.horizon_radius().value_or(0.0);
    nearest_ = horizon_ + kMediumAboveHorizon;
    const FlowNumbers flow = flow_numbers(spec_, scene.object.mass_suns.value_or(0.0));
    emission_ = flow.emission, absorption_ = flow.absorption;
}

double Medium::panel(const Place& place) const {
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
    const double length = apart(begin, between) + apart(between, end);
    if (std::min({begin.r, between.r, end.r}) > farthest_ && length < 2 * (between.r - farthest_)) return;
    if (depth < kDeepest && length > std::min({panel(begin), panel(between), panel(end)})) {
        split(from, begin, middle, between, depth + 1, at, way, nodes);
        split(middle, between, to, end, depth + 1, at, way, nodes);
    } else if (between.r > nearest_ && between.r < farthest_) {
        nodes.push_back({middle, between.r, between.theta, way(between, to - from)});
    }
}

void Medium::add_nodes(double from, double to, const At& at, const std::function<double(const Place&, double)>& way,
                       std::vector<MediumNode>& nodes) const {
    if (to > from && std::isfinite(to)) split(from, at(from), to, at(to), 0, at, way, nodes);
}

Medium::Light Medium::at(const MediumNode& node, double energy, double momentum) const {
    const PlaceMetric g = matter_.place(node.r, node.theta);
    // u_mu = u_t (-1, 0, 0, l), l = l0 R^1.5/(1 + R) in M; from u.u = -1.
    const double around = node.r * std::sin(node.theta) / 0.5, l = spec_.momentum * std::pow(around, 1.5) / (1 + around) * 0.5;
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
    const double share = depth > 1e-8 ? -std::expm1(-depth) / depth : 1 - 0.5 * depth;
    return {emitted * share * spec_.brightness * spec_.colour, std::exp(-depth)};
}

}  // namespace nullscope::reference
