#include "reference/warped_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nullscope::reference {
namespace {

constexpr double kLook = 0.04, kLookShare = 0.03;  // rad; of the radius
constexpr int kLookHalvings = 24, kLookBisections = 200, kLookDips = 40;
constexpr double kInRing = 1e-12;  // over the radius: a camera so close to the disc is in it, as elsewhere
constexpr double kBeforeRayEnd = 1e-12;

struct WarpedLook {
    double angle, r, height;
};

class WarpedWatch {
public:
    WarpedWatch(const PlaneRay& ray, const DiscShape& shape, int most) : ray_(ray), shape_(shape), most_(most) {}

    std::vector<double> all() {
        const double end = ray_.end() * (1 - kBeforeRayEnd);
        if (!std::isfinite(end)) return {};
        last_ = look(0);
        if (std::abs(last_.height) < kInRing) last_.height = 0;
        const int looks = static_cast<int>(std::ceil(end / kLook));
        for (int i = 1; i <= looks && !full(); ++i) look_on(look(end * i / looks), kLookHalvings);
        return met_;
    }

private:
    bool full() const { return static_cast<int>(met_.size()) >= most_; }

    WarpedLook look(double angle) const {
        const double r = angle > 0 ? ray_.radius_at(angle) : std::abs(ray_.photon().r);
        const double known = std::clamp(r, 1e-9, 1e15);  // beyond the sky's edge by a rounding r may be anything
        return {angle, known, dot(shape_.normal(known), ray_.plane().direction(angle))};
    }

    // Closer looks where the radius changes much among the rows.
    void look_on(const WarpedLook& next, int halvings) {
        const bool far =
            std::min(next.r, last_.r) > shape_.outermost() || std::max(next.r, last_.r) < shape_.innermost();
        if (halvings > 0 && !far && std::abs(std::log(next.r / last_.r)) > kLookShare) {
            look_on(look(0.5 * (last_.angle + next.angle)), halvings - 1);
            look_on(next, halvings - 1);
            return;
        }
        if (before_) look_for_dip(*before_, last_, next);
        look_between(last_, next);
        before_ = last_, last_ = next;
    }

    void look_between(WarpedLook from, WarpedLook to) {
        if (full() || !(from.height * to.height < 0 || (to.height == 0 && from.height != 0))) return;
        for (int i = 0; i < kLookBisections && to.height != 0; ++i) {
            const double share = i % 3 == 2 ? 0.5 : from.height / (from.height - to.height),
                         angle = from.angle + share * (to.angle - from.angle);
            if (!(angle > from.angle && angle < to.angle)) break;
            const WarpedLook found = look(angle);
            (found.height * to.height > 0 || found.height == 0 ? to : from) = found;
        }
        met_.push_back(std::abs(from.height) < std::abs(to.height) ? from.angle : to.angle);
    }

    // Towards the disc and away again between looks: by the lowest of three.
    void look_for_dip(WarpedLook before, WarpedLook middle, WarpedLook after) {
        const double side = middle.height > 0 ? 1 : -1;
        const auto over = [&](const WarpedLook& at) { return side * at.height; };
        if (!(over(middle) > 0 && over(before) > 0 && over(after) > 0)) return;
        for (int i = 0; i < kLookDips && over(middle) < over(before) && over(middle) < over(after); ++i) {
            const double a = middle.angle - before.angle, b = after.angle - middle.angle,
                         down = (over(before) - over(middle)) / a, up = (over(after) - over(middle)) / b,
                         lowest = middle.angle + 0.5 * (down * b - up * a) / (down + up);
            if (!(lowest > before.angle && lowest < after.angle) || lowest == middle.angle) return;
            const WarpedLook found = look(lowest);
            const bool earlier = found.angle < middle.angle;
            if (over(found) < 0) {
                look_between(earlier ? before : middle, found);
                look_between(found, earlier ? middle : after);
                return;
            }
            if (over(found) >= over(middle)) return;
            (earlier ? after : before) = middle;
            middle = found;
        }
    }

    const PlaneRay& ray_;
    const DiscShape& shape_;
    int most_;
    std::optional<WarpedLook> before_;
    WarpedLook last_{};
    std::vector<double> met_;
};

}  // namespace

std::vector<double> warped_crossings(const PlaneRay& ray, const DiscShape& shape, int most) {
    return WarpedWatch(ray, shape, most).all();
}

}  // namespace nullscope::reference
