#include "gradient/matter_ray.h"

#include <algorithm>
#include <cmath>

#include "gradient/extrapolated_step.h"
#include "gradient/step_error.h"

namespace nullscope {
namespace {

enum { kMatterDepth = kFlowStates, kMatterLight, kTransferStates };
using Transferred = std::array<Number, kTransferStates>;

class Transfer {
public:
    Transfer(const Flow& flow, const MatterGlow& glow, const Launch& from, const Number& shift, const MatterRule& rule)
        : flow_(flow), glow_(glow), shift_(shift), rule_(rule), rim_(1 / glow.farthest()) {
        RayState ray;
        photon_ = flow.launch(from, ray);
        std::ranges::copy(ray, here_.begin());
        inside_ = here_[kU].value > rim_;
    }

    MatterLight traced() {
        double length = 1e300;
        for (int steps = 0; steps < kMostSteps && !done(); ++steps) {
            const double longest = longest_step();
            length = std::min(length, longest);
            const Transferred rate = slope(here_);
            const auto [end, less_exact, enough] = step(rate, length);
            const double error = enough ? kEasyStep : error_of(end, less_exact);
            const bool within = end[kU].value < flow_.innermost() && end[kU].value > 0;
            // Where matter begins at once, however faint, steps get no shorter than this.
            const bool shortest = length <= kLeastStep * longest && within && std::isfinite(error);
            if ((error <= 1 && within) || shortest) {
                const bool ends_inside = end[kU].value > rim_;
                if (!inside_ && !ends_inside && length > kGrazing * longest && may_pass(end, length, longest)) {
                    length *= 0.5;
                    continue;
                }
                if (ends_inside != inside_)
                    to_rim(rate, length), inside_ = ends_inside;
                else
                    here_ = end;
                length *= std::clamp(0.9 * std::pow(std::max(error, 1e-30), -1 / kOrder), 0.3, 4.0);
            } else {
                const bool off = std::isfinite(error) && within;
                length *= off ? std::clamp(0.9 * std::pow(error, -1 / kOrder), 0.1, 0.7) : 0.4;
                if (length < 0.01 * kLeastStep * longest) break;  // it left the metric
            }
        }
        return {here_[kMatterLight], here_[kMatterDepth]};
    }

private:
    Transferred slope(const Transferred& s) const {
        RayState ray;
        std::copy_n(s.begin(), kFlowStates, ray.begin());
        const RayState rate = flow_.slope(photon_, ray, here_[kW].value < 0);
        Transferred all;
        std::ranges::copy(rate, all.begin());
        if (!inside_) return all;
        const MatterGlow::Rates matter = glow_.at(photon_, ray, shift_);
        all[kMatterDepth] = matter.depth, all[kMatterLight] = matter.light * exp(-s[kMatterDepth]);
        return all;
    }
    ExtrapolatedStep<Transferred> step(const Transferred& rate, double length) const {
        return extrapolated_step(
            here_, rate, length, [this](const Transferred& s) { return slope(s); },
            [this](const Transferred& end, const Transferred& less_exact) {
                return error_of(end, less_exact) <= kSpare;
            });
    }
    double error_of(const Transferred& end, const Transferred& less_exact) const {
        StepError error(end, less_exact);
        error.add_ray(photon_.energy.value, flow_.innermost());
        const double share = rule_.light / rule_.ray;
        error.add(kMatterDepth, 1, 1, share), error.add(kMatterLight, 1, std::max(rule_.faint, 1e-300), share);
        return error.over(rule_.ray);
    }
    double turn() const {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += here_[kTurn + i].value * here_[kTurn + i].value;
        return std::sqrt(sum);
    }
    double longest_step() const {
        const double turned = turn(), u = here_[kU].value, w = here_[kW].value;
        double longest = kLongestTurn / std::max(turned, 1e-150);
        if (w < 0) longest = std::min(longest, (inside_ ? kShareInside : kShare) * u / -w);
        if (inside_) longest = std::min(longest, kScales * glow_.scale(1) / std::hypot(turned, w / u));
        // What is dragged has the logarithm of the distance from the horizon.
        if (w > 0) longest = std::min(longest, kToHorizon * (flow_.innermost() - u) / w);
        return longest;
    }
    // Between here and the end, both beyond the rim, may the ray have been within? w falls about evenly from one to the other.
    bool may_pass(const Transferred& end, double length, double longest) const {
        constexpr double kUneven = 0.1;  // of a longest step
        const double before = here_[kW].value, after = end[kW].value;
        if (!(before > 0 && after < 0)) return false;
        const double rise = 0.5 * length / (before - after);
        const double nearest = std::max(here_[kU].value + rise * before * before, end[kU].value + rise * after * after);
        return nearest > rim_ * (1 - kUneven * length / longest);
    }
    bool done() const {
        const double u = here_[kU].value, w = here_[kW].value;
        return u * glow_.nearest() > 1 || (!inside_ && w < 0 && u * kBeyondOrbits < 1);
    }
    // By Newton's steps within a bracket, the last ones in duals: the place where u is the rim's, whatever the seeds.
    void to_rim(const Transferred& rate, double length) {
        double low = 0, high = length, at = 0.5 * length;
        const bool after = !inside_;
        Transferred there = here_;
        for (int tries = 0; tries < kMostTries; ++tries) {
            there = step(rate, at).end;
            const double move = (rim_ - there[kU].value) / there[kW].value;
            if (std::fabs(move) < kAtRim * length) break;
            ((there[kU].value > rim_) == after ? high : low) = at;
            at = at + move > low && at + move < high ? at + move : 0.5 * (low + high);
        }
        for (int newton = 0; newton < 2; ++newton) {
            const Transferred now = slope(there);
            const Number by = (rim_ - there[kU]) / there[kW];
            for (std::size_t i = 0; i < kTransferStates; ++i) there[i] = there[i] + by * now[i];
        }
        here_ = there;
    }

    static constexpr double kSpare = 0.01;       // of the error allowed: derivatives of light are less exact than light
    static constexpr double kOrder = 13.0;       // of the error that steps are chosen by
    static constexpr double kLongestTurn = 1.0;  // rad, of a step
    static constexpr double kShare = 0.9999;     // of the way to the sky, of a step
    static constexpr double kToHorizon = 0.4;    // of the way to the horizon, of a step
    static constexpr double kShareInside = 0.5;  // the same in matter
    static constexpr double kScales = 4.0;       // of the matter, of a step in it
    static constexpr double kLeastStep = 1e-7;   // of the longest
    static constexpr double kGrazing = 1e-3;     // of the longest step: what matter a shorter one may miss
    static constexpr double kBeyondOrbits = 3.0;  // r_s, from where light that goes outward does not come back
    static constexpr double kAtRim = 1e-11;       // of a step
    static constexpr int kMostSteps = 4000, kMostTries = 60;

    const Flow& flow_;
    const MatterGlow& glow_;
    Number shift_;
    MatterRule rule_;
    double rim_;
    Photon photon_;
    Transferred here_{};
    bool inside_ = false;
};

}  // namespace

MatterLight matter_along(const Flow& flow, const MatterGlow& glow, const Launch& from, const Number& shift,
                         const MatterRule& rule) {
    return Transfer(flow, glow, from, shift, rule).traced();
}

}  // namespace nullscope
