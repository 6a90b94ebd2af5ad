// Flight through the throat of a wormhole as OpenGL draws it: rays, fates and picture change on the way by what the way itself
// changes, and by nothing more at l = 0, where the near side's tables hand over to the far side's.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "support/draft.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// d(phi)/dl = |tan(alpha)| over the throat's radius in it and less elsewhere, alpha from the radial direction. Rays within kRim of the
// rim are left out, for the sky turns faster there than a frame shows: tan(alpha) is below 10; the rest is for two directions.
constexpr double kRim = 0.1, kSteepest = 16.0;
// Of two frames' directions: straight lines of the strip, 1.8e-6 rad, a few times, and float.
constexpr double kFloor = 2e-5;

struct Shot {
    double l;
    RayFrame rays;
    Image<float> picture;
};

double plane_width() { return 2 * std::tan(55 * M_PI / 180); }

Scene looking_across(const std::string& metric, const MetricParameters& parameters, double l) {
    Draft draft;
    draft.scene.name = "throat";
    // The rim in the middle: one sky on each side.
    return draft.metric(metric, parameters).size(96, 54).plane(plane_width()).r(l).yaw(M_PI / 2);
}

// Largest change of a ray's sky direction over what the way between the two shots may make; infinite for another sky.
double largest_change(const Shot& a, const Shot& b, int& judged) {
    const double allowed = kSteepest * std::fabs(a.l - b.l) + kFloor;
    double worst = 0;
    for (std::size_t i = 0; i < a.rays.pixels.size(); ++i) {
        const RayPixel &p = a.rays.pixels[i], &q = b.rays.pixels[i];
        const double u = (static_cast<double>(i % 96) + 0.5 - 48) / 96 * plane_width(),
                     v = (static_cast<double>(i / 96) + 0.5 - 27) / 96 * plane_width();
        if (std::fabs(u) < kRim * std::hypot(u, v, 1.0)) continue;
        ++judged;
        if (p.fate != q.fate) return INFINITY;
        worst = std::max(worst, length(p.sky - q.sky) / allowed);
    }
    return worst;
}

TEST_CASE("flight through the throat: rays go on changing as the way does, with both skies and no seam at l = 0" *
          test::costly()) {
    const std::vector<double> way = {4e-3, 3e-3, 2e-3, 1e-3, 1e-6, 1e-9, 0.0, -1e-9, -1e-6, -1e-3, -2e-3, -3e-3, -4e-3};
    const std::vector<std::pair<std::string, MetricParameters>> holes = {
        {"ellis", {}},
        {"dneg-wormhole", {{"length", 0.0}}},
        {"dneg-wormhole", {}},
        {"dneg-wormhole", {{"length", 1.0}, {"lensing_width", 0.5}}}};
    on_every_context([&](GpuSession& session) {
        for (const auto& [metric, parameters] : holes) {
            CAPTURE(metric);
            std::vector<Shot> shots;
            for (const double l : way) {
                RayFrame rays = gl_ray_data(session, looking_across(metric, parameters, l));
                shots.push_back({l, std::move(rays), session.renderer->picture()});
            }
            double worst = 0;
            for (std::size_t i = 1; i < shots.size(); ++i) {
                int judged = 0;
                const double change = largest_change(shots[i - 1], shots[i], judged);
                worst = std::max(worst, change);
                CHECK_MESSAGE(change <= 1, "from l = ", shots[i - 1].l, " to ", shots[i].l);
                CHECK(judged > 96 * 54 / 2);
            }
            const Shot& middle = shots[way.size() / 2];
            const auto of = [&](Fate fate) {
                return std::count_if(middle.rays.pixels.begin(), middle.rays.pixels.end(),
                                     [&](const RayPixel& p) { return p.fate == fate; });
            };
            CHECK(of(Fate::kEscaped) > 96 * 54 / 3);
            CHECK(of(Fate::kOtherSide) > 96 * 54 / 3);
            fmt::print("{:<7} {:<14} largest change over what the way makes {:.2f}; near sky {}, far sky {} pixels\n",
                       session.context->kind(), metric, worst, of(Fate::kEscaped), of(Fate::kOtherSide));
            // The check can fail: half the way further on is no longer within what a billionth makes.
            Shot planted = shots[3];
            planted.l = middle.l + 1e-9;
            int judged = 0;
            CHECK(largest_change(planted, middle, judged) > 1);
        }
    });
}

}  // namespace
