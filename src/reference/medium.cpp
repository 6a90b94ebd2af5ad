#include "reference/medium.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"

namespace nullscope::reference {
namespace {

constexpr int kDeepestStep = 24;  // halvings

double apart(const MatterPlace& a, const MatterPlace& b, bool all_round) {
    const Vec3 from = a.flat(), to = b.flat();
    const double out = all_round ? b.off_axis() - a.off_axis() : 0, up = to.z - from.z;
    const double by_place = all_round ? std::sqrt(out * out + up * up) : std::sqrt(dot(to - from, to - from));
    return std::max(by_place, std::abs(a.r - b.r));
}

// In the middle of a width, by central differences.
MatterPlace::Slopes slopes_between(const MatterPlace& middle, double along, double width, const Medium::Way& way) {
    const double beside = 1e-3 * width, parameter = way.affine(middle, 2 * beside);
    const MatterPlace before = way.at(along - beside), after = way.at(along + beside);
    const auto polar = [](const MatterPlace& p) {
        return std::atan2(std::hypot(p.direction.x, p.direction.y), p.direction.z);
    };
    return {(after.r - before.r) / parameter, (polar(after) - polar(before)) / parameter};
}

}  // namespace

Medium::Medium(const Scene& scene, const Metric& matter)
    : matter_(matter),
      model_(make_matter(scene, matter)),
      law_(scene),
      moves_(medium_moves(*scene.medium) != nullptr && scene.light.delay),
      by_direction_(!model_->goes_round() || scene.medium->field_direction != FieldDirection::kIsotropic),
      nearest_(model_->horizon() + kMediumAboveHorizon) {}

Medium::Look Medium::look(double along, const Way& way) const {
    const Place place = way.at(along);
    return {along, place, model_->panel(place)};
}

void Medium::split(const Look& begin, const Look& end, int depth, const Way& way,
                   std::vector<MediumNode>& nodes) const {
    const Look between = look(0.5 * (begin.along + end.along), way);
    const double r = between.place.r, farthest = model_->farthest();
    const bool all_round = model_->all_round();
    const double length = apart(begin.place, between.place, all_round) + apart(between.place, end.place, all_round);
    if (std::min({begin.place.r, r, end.place.r}) > farthest && length < 2 * (r - farthest)) return;
    const bool turns =
        model_->turn() > 0 && std::max({begin.place.r, r, end.place.r}) < 2 * farthest &&
        apart(begin.place, between.place, false) + apart(between.place, end.place, false) > model_->turn();
    if (depth < kDeepestStep && (turns || length > std::min({begin.panel, between.panel, end.panel}))) {
        split(begin, between, depth + 1, way, nodes);
        split(between, end, depth + 1, way, nodes);
    } else if (r > nearest_ && r < farthest) {
        const double width = end.along - begin.along;
        MediumNode node{between.along, r, between.place.direction, between.place.delay,
                        way.affine(between.place, width)};
        if (by_direction_) {
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
    constexpr double kNearAxis = 1e-9;  // of the sine, where there is no azimuth
    const PlaceMetric g = matter_.place(node.r, std::max(node.sine(), kNearAxis), node.cosine());
    const auto state = model_->at(node, g);
    return state ? law_.at(*state, g, node, energy, momentum) : Light{{0, 0, 0}, 1};
}

}  // namespace nullscope::reference
