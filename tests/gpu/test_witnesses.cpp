// Four witnesses of a pixel: reference A, shader core in double B64 and in float B32, both with the real table, GL C.
// A - B64 is the table's error, B64 - B32 that of single precision, B32 - C the driver's. Each has its own bound, so that a
// failing frame says which part it comes from.
#include <algorithm>
#include <vector>

#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Interpolation in strip and orbit table: below 2e-4 px for the sky; positions on the disc near the critical ray reach 4.2e-3 px
// (measured at 1280x720 over 60 to 110 degrees), where an orbit winds and the map's cells are widest against a pixel.
constexpr double kTable_px = 0.01;
// A few float roundings (6e-8) of angles of order pi, over pixels of 8e-4 to 2e-3 rad: 8e-4 px measured.
constexpr double kFloat_px = 0.003;
// llvmpipe fuses multiplications and additions: 8.3e-4 px measured. Others also approximate roots and divisions to some roundings.
constexpr double kDriver_px = 0.005;

constexpr int kColumnStep = 13,
              kRowStep = 11;  // 99 x 66 pixels of 1280x720: primes, so that no pattern of the image is hit

struct Steps {
    std::vector<float> table, single, driver;
};

void add_pixel(Steps& steps, const Verdict& verdict) {
    // A pixel whose ends differ lies on an edge; the frame tests judge it, with their bands.
    if (std::max({verdict.table_px, verdict.float_px, verdict.driver_px}) > 1e30) return;
    steps.table.push_back(static_cast<float>(verdict.table_px));
    steps.single.push_back(static_cast<float>(verdict.float_px));
    steps.driver.push_back(static_cast<float>(verdict.driver_px));
}

TEST_CASE("witnesses: table, float and driver errors each stay within their own bound" * test::costly()) {
    on_every_context([](GpuSession& session) {
        Selection selection(2);
        for (const std::string name :
             {"flat", "sky-only", "first-light", "near-horizon", "fast-flyby", "translucent-disc"}) {
            if (!selection.takes_next()) continue;
            CAPTURE(name);
            auto scene = load_scene(name);
            REQUIRE(scene);
            scene->sky.kind = SkyKind::kBlack;
            const RayFrame frame = gl_ray_data(session, *scene);
            const CoreInput input = session.renderer->tables().core_input();
            const ExactTrace trace = reference_trace(*scene);
            Steps steps;
            int pixels = 0;
            for (int y = kRowStep / 2; y < frame.height; y += kRowStep)
                for (int x = kColumnStep / 2; x < frame.width; x += kColumnStep, ++pixels)
                    add_pixel(steps, verdict_of(witnesses_of(*scene, input, frame, x, y),
                                                exact_pixel(scene->camera, trace, x, y)));
            const Spread table = spread_of(steps.table), single = spread_of(steps.single),
                         driver = spread_of(steps.driver);
            fmt::print("{:<7} {:<17} table {}, float {}, driver {} px (max / 99.9 % / median), {} of {} pixels\n",
                       session.context->kind(), name, spread_text(table), spread_text(single), spread_text(driver),
                       steps.table.size(), pixels);
            constexpr double kOnEdges = 0.002;  // of the pixels may lie on edges
            CHECK(static_cast<double>(steps.table.size()) >= (1 - kOnEdges) * pixels);
            CHECK(table.max <= kTable_px);
            CHECK(single.max <= kFloat_px);
            CHECK(driver.max <= kDriver_px);
        }
    });
}

}  // namespace
