#include "reference/leaning_watch.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {

constexpr int kPlaneLooks = 8;  // of a step, which is at most a radian long
// Of Boyer and Lindquist's azimuth, rad: next to a horizon it winds up, and the plane with it.
constexpr double kFarRound = 0.5;
constexpr double kOutOfHorizon = 1.001, kFirstMet = 1.04;  // of its radius
constexpr int kWoundHalvings = 12;                         // of the way between two looks
constexpr int kPlaneHalvings = 200, kPlaneDips = 12;
constexpr double kBesidePlane = 1e-12;  // over the radius: a camera so close to the plane is in it, as elsewhere

}  // namespace

LeaningWatch::Sample LeaningWatch::sample(double along, const KerrStep& step) const {
    const KerrStep& at = along < step.from && previous_ ? *previous_ : step;
    const KerrPlace place = along == at.from ? at.begin : along == at.to ? at.end : at.between(along);
    return {along, dot(place.flat(), plane_.normal) / place.r, place.phi};
}

void LeaningWatch::see(const KerrStep& step) {
    if (static_cast<int>(met_.size()) >= most_) return;
    if (!last_) {
        last_ = sample(step.from, step);
        comes_out_ = step.begin.r < kOutOfHorizon * hole_.outer();
        if (std::abs(last_->height) < kBesidePlane) last_->height = 0;
    }
    for (int i = 1; i <= kPlaneLooks; ++i) {
        const double along = i == kPlaneLooks ? step.to : step.from + (step.to - step.from) * i / kPlaneLooks;
        look_on(sample(along, step), step, kWoundHalvings);
    }
    previous_ = step;
}

void LeaningWatch::look_on(Sample next, const KerrStep& step, int halvings) {
    if (halvings > 0 && std::abs(next.phi - last_->phi) > kFarRound) {
        look_on(sample(0.5 * (last_->along + next.along), step), step, halvings - 1);
        look_on(next, step, halvings - 1);
        return;
    }
    if (before_) look_for_dip(*before_, *last_, next, step);
    look_between(*last_, next, step);
    before_ = last_, last_ = next;
}

void LeaningWatch::look_between(Sample from, Sample to, const KerrStep& step) {
    if (from.height * to.height < 0 || (to.height == 0 && from.height != 0)) meet(from, to, step);
}

// Towards the plane and away again between two looks: by parabolas through the lowest three.
void LeaningWatch::look_for_dip(Sample before, Sample middle, Sample after, const KerrStep& step) {
    const double side = middle.height > 0 ? 1 : -1;
    const auto over = [&](const Sample& s) { return side * s.height; };
    if (!(over(middle) > 0 && over(before) > 0 && over(after) > 0)) return;
    for (int i = 0; i < kPlaneDips && over(middle) < over(before) && over(middle) < over(after); ++i) {
        const double a = middle.along - before.along, b = after.along - middle.along;
        const double down = (over(before) - over(middle)) / a, up = (over(after) - over(middle)) / b;
        const double lowest = middle.along + 0.5 * (down * b - up * a) / (down + up);
        if (!(lowest > before.along && lowest < after.along) || lowest == middle.along) return;
        const Sample found = sample(lowest, step);
        if (over(found) < 0) {
            meet(found.along < middle.along ? before : middle, found, step);
            meet(found, found.along < middle.along ? middle : after, step);
            return;
        }
        if (over(found) >= over(middle)) return;
        (found.along < middle.along ? after : before) = middle;
        middle = found;
    }
}

// By regula falsi and halving in turn; the place by the step integrated anew.
void LeaningWatch::meet(Sample from, Sample to, const KerrStep& step) {
    for (int i = 0; i < kPlaneHalvings && to.height != 0; ++i) {
        const double share = i % 3 == 2 ? 0.5 : from.height / (from.height - to.height);
        const double along = from.along + share * (to.along - from.along);
        if (!(along > from.along && along < to.along)) break;
        const Sample found = sample(along, step);
        (found.height * to.height > 0 || found.height == 0 ? to : from) = found;
    }
    if (std::abs(from.height) < std::abs(to.height)) to = from;  // what is left is a rounding of the other
    const KerrStep& at = to.along < step.from && previous_ ? *previous_ : step;
    const KerrGlance glance = at.glance(to.along, false);
    const KerrPlace place = at.at(to.along);
    if (comes_out_ && place.r < kFirstMet * hole_.outer()) return;
    const double x = kerr_distance(hole_, place.r, std::sin(place.theta)), rate = x * x;
    met_.push_back({place, to.along, glance.r_slope / rate, glance.theta_slope / rate});
}

// The photon moves against the ray. With p_theta and p_phi over the unit sphere its turn about the axis N is (p_theta e_theta +
// p_phi/sin(theta) e_phi) . (N x n).
std::vector<PlaneCrossing> LeaningWatch::crossings(const KerrRay& ray) const {
    std::vector<PlaneCrossing> list;
    for (const Met& met : met_) {
        const KerrPlace& at = met.place;
        if (static_cast<int>(list.size()) >= most_) break;
        const double c = std::cos(at.theta), s = std::sin(at.theta), sigma = at.r * at.r + hole_.a * hole_.a * c * c;
        const Vec3 n = at.flat() / at.r, east{-std::sin(at.phi), std::cos(at.phi), 0},
                   south{c * east.y, -c * east.x, -s}, ahead = cross(plane_.normal, n);
        const double p_theta = -sigma * met.theta_slope / ray.energy;
        PlaneCrossing crossing{met.along, at.r, at.phi, 0, at.delay};
        const double a2 = hole_.a * hole_.a, round = at.r * at.r + a2, delta = round - hole_.twice_mass(at.r) * at.r;
        crossing.climb = -met.r_slope * sigma / (ray.energy * std::sqrt(round * round - a2 * delta * s * s));
        crossing.l = p_theta * dot(south, ahead) + ray.l_z / s * dot(east, ahead);
        crossing.bearing = std::atan2(dot(n, plane_.y), dot(n, plane_.x));
        crossing.cosine = c;
        const double pull = hole_.twice_mass(at.r) * at.r / sigma, g_tt = pull - 1, g_tp = -hole_.a * pull * s * s,
                     g_pp = (round - g_tp * hole_.a) * s * s, det = g_tt * g_pp - g_tp * g_tp;
        const double up_theta = dot(plane_.normal, south), up_phi = s * dot(plane_.normal, east),
                     k_phi = (g_tt * ray.l_z + g_tp) / det;
        crossing.across = std::abs(met.theta_slope / ray.energy * up_theta - k_phi * up_phi) /
                          std::sqrt(up_theta * up_theta / sigma + g_tt / det * up_phi * up_phi);
        list.push_back(crossing);
    }
    return list;
}

}  // namespace nullscope::reference
