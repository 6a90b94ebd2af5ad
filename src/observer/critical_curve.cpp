#include "observer/critical_curve.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "observer/critical_light.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

constexpr int kArcs = 64, kMostHalvings = 12;
constexpr double kBefore = 0.035;     // cosine of the angle to the middle beyond which nothing is drawn: 88 degrees
constexpr double kDeparture = 0.1;    // px, in the picture
constexpr double kFromMiddle = 1e-3;  // of a point's distance from the middle: outside of the picture less will do

struct Point {
    double angle;
    Vec3 direction;
    bool before;
    double x, y;  // px, where it is before the camera
};

class Lines {
public:
    Lines(const CriticalLight& light, const CameraSpec& camera) : light_(light), camera_(camera) {
        Point last = point(0.0);
        add(last);
        for (int i = 1; i <= kArcs; ++i) {
            const Point next = point(2.0 * std::numbers::pi * i / kArcs);
            arc(last, next, 0);
            last = next;
        }
        end();
    }
    std::vector<PictureLine> take() { return std::move(lines_); }

private:
    Point point(double angle) const {
        const Vec3 d = light_.direction(angle);
        const bool before = !projection_of(camera_).flat || -d.z > kBefore;
        const auto seen = before ? pixel_of(camera_, d) : std::nullopt;
        return seen ? Point{angle, d, true, (*seen)[0], (*seen)[1]} : Point{angle, d, false, 0.0, 0.0};
    }

    // All but its first point.
    void arc(const Point& from, const Point& to, int halvings) {
        const Point middle = point(0.5 * (from.angle + to.angle));
        const int before = (from.before ? 1 : 0) + (middle.before ? 1 : 0) + (to.before ? 1 : 0);
        const bool done = before == 0 || (before == 3 && straight(from, middle, to));
        if (done || halvings == kMostHalvings) return add(middle), add(to);
        arc(from, middle, halvings + 1);
        arc(middle, to, halvings + 1);
    }

    bool straight(const Point& from, const Point& middle, const Point& to) const {
        const double dx = to.x - from.x, dy = to.y - from.y, chord = std::hypot(dx, dy);
        const double aside = std::fabs(dx * (middle.y - from.y) - dy * (middle.x - from.x)) / std::fmax(chord, 1e-9);
        const double out = std::hypot(middle.x - 0.5 * camera_.width, middle.y - 0.5 * camera_.height);
        return aside < std::fmax(kDeparture, out > camera_.width + camera_.height ? kFromMiddle * out : 0.0);
    }

    void add(const Point& point) {
        if (!point.before) return end();
        if (!line_.empty() && std::fabs(point.x - line_.back()[0]) > 0.5 * turn_px(camera_) && turn_px(camera_) > 0.0)
            end();  // round the camera
        line_.push_back({point.x, point.y});
    }
    void end() {
        if (line_.size() > 1) lines_.push_back(std::move(line_));
        line_.clear();
    }

    const CriticalLight& light_;
    const CameraSpec& camera_;
    PictureLine line_;
    std::vector<PictureLine> lines_;
};

}  // namespace

std::vector<PictureLine> critical_curve(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light) {
    const auto critical = CriticalLight::make(spacetime, camera, light);
    if (!critical) return {};
    return Lines(*critical, camera).take();
}

}  // namespace nullscope
