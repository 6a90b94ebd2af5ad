// Bodies thinner than a pixel keep their light: it is how much of a pixel they cover that counts, not how thick they are along the ray.
#include <cmath>
#include <functional>
#include <vector>

#include "scene/bodies.h"
#include "sky/sky.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kThinBodiesSamples = 3;  // a side and pixel, of the reference
// Of the light: edges are softened half a pixel outward where a body has corners, and to both sides where it is round.
constexpr double kTotal = 0.06;

struct ThinBodiesCase {
    const char* name;
    std::function<void(Scene&)> set;
};

void kerr(Scene& s) { s.spacetime = {"kerr", {{"spin", 0.9}}}; }
void thin_bodies_flat(Scene& s) { s.spacetime.metric = "minkowski"; }
void ring(Scene& s, double height) {
    add<CylinderSpec>(s).inner = 4, first_shape<CylinderSpec>(s)->outer = 8,
    first_shape<CylinderSpec>(s)->height = height;
}
void ball(Scene& s, double radius) {
    add<BallSpec>(s).position = {6, 1, 0.5}, first_shape<BallSpec>(s)->radius = radius;
}

const std::vector<ThinBodiesCase>& thin_bodies_cases() {
    static const std::vector<ThinBodiesCase> all = {
        {"thin ring, flat", [](Scene& s) { thin_bodies_flat(s), ring(s, 0.05); }},
        {"thin ring", [](Scene& s) { ring(s, 0.05); }},
        {"thin ring, rotating hole", [](Scene& s) { kerr(s), ring(s, 0.05); }},
        {"thick ring, flat", [](Scene& s) { thin_bodies_flat(s), ring(s, 1.5); }},
        {"thick ring, rotating hole", [](Scene& s) { kerr(s), ring(s, 1.5); }},
        {"ball of six pixels, flat", [](Scene& s) { thin_bodies_flat(s), ball(s, 1.5); }},
        {"ball of six pixels", [](Scene& s) { ball(s, 1.5); }},
        {"ball of six pixels, rotating hole", [](Scene& s) { kerr(s), ball(s, 1.5); }},
        {"torus of four pixels, flat",
         [](Scene& s) {
             thin_bodies_flat(s), add<SurfaceSpec>(s).shape = "(length(x, y) - 6)^2 + z^2 - 1",
                                  first_shape<SurfaceSpec>(s)->bound = 8;
         }},
    };
    return all;
}

double light(const Image<float>& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) sum += static_cast<double>(picture.at(x, y)[1]);
    return sum;
}

TEST_CASE("thin bodies: as much light as the reference's" * test::costly()) {
    std::map<std::string, double> exact_light;
    on_every_context([&](GpuSession& session) {
        Selection selection(3);
        for (const ThinBodiesCase& c : thin_bodies_cases()) {
            if (!selection.takes_next()) continue;
            const std::string name = c.name;
            CAPTURE(name);
            Scene scene;
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.r = 30, scene.camera.theta = 1.3;
            scene.camera.width = 48, scene.camera.height = 27;
            scene.camera.plane_width = 0.6 * scene.camera.focal_distance;
            c.set(scene);
            REQUIRE(session.renderer->prepare(scene));
            if (!exact_light.contains(name)) {
                const auto sky = build_sky(scene.sky, {}, 16);
                REQUIRE(sky);
                const auto exact = reference::render_frame(scene, *sky, nullptr, kThinBodiesSamples, {});
                REQUIRE(exact);
                exact_light[name] = light(*exact);
            }
            const double drawn = light(session.renderer->picture()), all = exact_light[name];
            fmt::print("{:<7} {:<35} light {:.4f} of the reference's {:.1f}\n", session.context->kind(), c.name,
                       drawn / all, all);
            CHECK(all > 1);
            CHECK(std::abs(drawn / all - 1) <= kTotal);
        }
    });
}

}  // namespace
