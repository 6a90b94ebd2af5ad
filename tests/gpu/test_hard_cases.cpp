// The list of hard cases on every context, each within its bound. Depth quick draws and measures every fourteenth and
// those that shows_a_breach names, depth all draws all and measures these and every fifth, depth everything all.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "compare/hard_cases.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

bool whole(const RayFrame& frame) {     // every channel finite, every fate one that there is, directions of length 1
    constexpr double kUnit = 1e-5;      // a float normalisation, with room
    constexpr double kHalfTurn = 1e-5;  // of a half turn: next to a whole number of them either order will do;
    // And so it will where a float no longer tells half turns apart, in a wormhole's long tube.
    constexpr double kFloat = 2e-7;
    for (const RayPixel& p : frame.pixels) {
        if (!all_finite(p)) return false;
        if (p.fate != Fate::kEscaped && p.fate != Fate::kCaptured && p.fate != Fate::kOtherSide &&
            p.fate != Fate::kHit && p.fate != Fate::kNoSky)
            return false;
        const double half_turns = p.angle / M_PI;
        if (p.order != static_cast<int>(half_turns) &&
            std::abs(half_turns - std::round(half_turns)) > kHalfTurn + kFloat * half_turns)
            return false;
        const bool on_a_sky = p.fate == Fate::kEscaped || p.fate == Fate::kOtherSide;
        if (std::abs(length(p.sky) - (on_a_sky ? 1.0 : 0.0)) > kUnit) return false;
    }
    return true;
}

constexpr double kRefineAbove_px = 1e-5;  // below every bound of the list but those of frames of a pixel or two

// At any depth: images of high order, one after the other from one place, for which nothing but the view narrows.
bool shows_a_breach(const HardCase& c) { return c.name == "image order 3" || c.name == "image order 6"; }

TEST_CASE("hard cases: every one within its bound") {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        int number = 0;
        for (const HardCase& c : hard_cases()) {
            const bool chosen = number++ % by_depth(14, 5, 5) == 0 || shows_a_breach(c);
            if (!chosen && depth() == Depth::kQuick) continue;
            CAPTURE(c.name);
            session.renderer->set_method(Method{.cubic = hard_cubic(c.scene)});
            const RayFrame frame = gl_ray_data(session, c.scene);
            CHECK(whole(frame));
            if (measured.known(c.name, frame) || (!chosen && !everything_asked())) continue;
            const ExactTrace trace = remembered(reference_trace(c.scene));
            const HardBound bound = hard_bound(c.scene, exact_frame(c.scene.camera, trace));
            const RayMeasures m = measure_rays(frame, c.scene.camera, trace, 1, kRefineAbove_px);
            fmt::print(
                "{:<7} {:<55} sky {:.1e} of {:.1e}, place {:.1e} of {:.1e}, swept {:.1e} of {:.1e}, g {:.1e} of {:.1e} "
                "px; fate errors {}, "
                "forgiven {}\n",
                session.context->kind(), c.name, m.sky_px.max, bound.sky, m.place_px.max, bound.place, m.angle_px.max,
                bound.swept, m.g_px.max, bound.g, m.fate_errors, m.forgiven);
            CHECK(m.fate_errors == 0);
            CHECK(m.sky_px.max <= bound.sky);
            CHECK(m.place_px.max <= bound.place);
            CHECK(m.angle_px.max <= bound.swept);
            CHECK(m.g_px.max <= bound.g);
        }
    });
    fmt::print("{} frames have the same bits on a second context\n", measured.count());
}

}  // namespace
