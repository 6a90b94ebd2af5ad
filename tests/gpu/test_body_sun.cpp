// Bodies lit by a far sun: the shader's light against the reference's, pixel by pixel.
#include <algorithm>
#include <cmath>

#include "base/assets.h"
#include "reference/reference.h"
#include "support/draft.h"
#include "support/gpu_session.h"

using namespace nullscope;

namespace {

Body plain(BodyShape shape) {
    Body body;
    body.shape = std::move(shape);
    body.material.texture = TextureKind::kPlain;
    body.material.night = 0.1, body.material.sun_longitude = 1.1, body.material.sun_latitude = 0.4;
    return body;
}

Scene lit(const std::string& metric) {
    test::Draft draft;
    draft.metric(metric).place(20, 1.3).size(96, 54).plane(1.0).sky(SkyKind::kBlack);
    if (metric == "kerr") draft.spin(0.7).by(ObserverKind::kZamo);
    Scene scene = draft;
    scene.picture.refine = false;
    scene.bodies = {plain(BallSpec{{-4, 4, 1}, 2}), plain(CylinderSpec{5, 7, 0.5})};
    return scene;
}

TEST_CASE("body sun: the light of bodies lit by a far sun is the reference's" * test::costly()) {
    constexpr double kLight = 2e-3;  // of colours up to 1: in flat coordinates a float's place
    constexpr double kEdges = 0.12;  // of the lit pixels: rims are covered in part, in the reference's one ray not
    for (const char* metric : {"schwarzschild", "kerr", "minkowski"}) {
        CAPTURE(std::string(metric));
        const Scene scene = lit(metric);
        const auto sky = build_sky(scene.sky, assets_directory(), 256);
        REQUIRE(sky);
        const auto exact = reference::render_frame(scene, *sky, {}, 1);
        REQUIRE(exact);
        test::on_every_context([&](test::GpuSession& session) {
            const Image<float> picture = test::picture_of(session, scene);
            int lit_pixels = 0, off = 0, dark = 0;
            for (std::size_t i = 0; i < picture.data.size(); i += 3) {
                if (exact->data[i] <= 0) continue;
                ++lit_pixels;
                dark += exact->data[i] < 0.15F;
                off += !(std::abs(picture.data[i] - exact->data[i]) <= kLight);
            }
            fmt::print("{}: {}: {} of {} pixels off by more than {}, {} of them on the night's side\n",
                       session.context->kind(), metric, off, lit_pixels, kLight, dark);
            CHECK(lit_pixels > 200);
            CHECK(dark > 20);
            CHECK(off <= kEdges * lit_pixels);
        });
    }
}

}  // namespace
