// The list of hard cases on every context, each within its bound.
#include <algorithm>
#include <cmath>

#include "compare/hard_cases.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

bool whole(const RayFrame& frame) {  // every channel finite, every fate one that there is, directions of length 1
    constexpr double kUnit = 1e-5;   // a float normalisation, with room
    for (const RayPixel& p : frame.pixels) {
        if (!all_finite(p)) return false;
        if (p.fate != Fate::kEscaped && p.fate != Fate::kCaptured && p.fate != Fate::kHit) return false;
        if (std::abs(length(p.sky) - (p.fate == Fate::kEscaped ? 1.0 : 0.0)) > kUnit) return false;
    }
    return true;
}

TEST_CASE("hard cases: every one within its bound") {
    on_every_context([](GpuSession& session) {
        for (const HardCase& c : hard_cases()) {
            CAPTURE(c.name);
            const bool cubic = pixel_angle(c.scene.camera, 0.5, 0.5) < 2e-5;
            session.renderer->set_method(Method{.cubic = cubic});
            const RayFrame frame = gl_ray_data(session, c.scene);
            CHECK(whole(frame));
            const RayMeasures m = measure_rays(frame, c.scene.camera, reference_trace(c.scene));
            const double bound = hard_bound_px(c.scene.camera, cubic);
            fmt::print("{:<7} {:<55} bound {:.1e} screen {:.1e}, place {:.1e}, swept {:.1e}, g {:.1e} px; fate errors {}, forgiven {} {}\n",
                       session.context->kind(), c.name, bound, m.sky_px.max, m.place_px.max, m.angle_px.max, m.g_px.max, m.fate_errors, m.forgiven,
                       std::max({m.sky_px.max, m.place_px.max, m.angle_px.max, m.g_px.max}) > bound ? "BEYOND" : "");
            CHECK(m.fate_errors == 0);
            CHECK(m.sky_px.max <= bound);
            CHECK(m.place_px.max <= bound);
            CHECK(m.angle_px.max <= bound);
            CHECK(m.g_px.max <= bound);
        }
    });
}

}  // namespace
