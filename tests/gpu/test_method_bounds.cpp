// Every method of tracing in its default form against the reference. The method tells where a ray goes; its verdict, escaped or
// captured, is the same for all, so no method may have a fate error.
#include "against_reference.h"
#include "shaderlib/method.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

TEST_CASE("method bounds: each stays within its screen error and none has a fate error" * test::costly()) {
    // Largest over the cameras, measured with llvmpipe where a pixel spans 1.8e-3 rad: 7.3e-4 px for the first three (single precision at the
    // photon ring), 7.0e-3 px for the integrator, close to the horizon; times 2.7.
    constexpr double kTables_px = 0.002, kIntegrator_px = 0.02;
    AgainstReference tables("method bounds", {.sky = kTables_px}), integrator("method bounds", {.sky = kIntegrator_px});
    on_every_context([&](GpuSession& session) {
        for (const auto& [r, yaw] : {std::pair{15.0, 0.0}, {3.0, 0.6}, {1.2, M_PI}})
            for (const char* method : {"strip", "table", "closed-form", "integrate"}) {
                session.renderer->set_method(*parse_method(method));
                AgainstReference& judge = method == std::string("integrate") ? integrator : tables;
                judge.frame(session, fmt::format("{} r = {}", method, r),
                            Draft().sky(SkyKind::kBlack).size(640, 360).r(r).yaw(yaw));
            }
    });
}

}  // namespace
