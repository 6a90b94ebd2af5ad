// A plunge about a rotating hole as OpenGL draws it: round it and through its horizon, without a seam or a jump.
#include "against_reference.h"
#include "jumps.h"
#include "observer/path.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"
#include "support/folders.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kKerrPlungeWidth = 24, kKerrPlungeHeight = 14;
// What a step may add to the reference's: twice the error of a direction, float and steps of a tenth of a pixel of 1080p at most, where the
// sky turns ten times as fast as the pixel.
constexpr double kJump = 2e-4;

std::string plunge_file() { return (data_folder() / "golden/scenes/kerr-circling.toml").string(); }

Scene plunging(bool disc) {
    Scene scene = *load_scene(plunge_file());
    scene.camera.width = kKerrPlungeWidth, scene.camera.height = kKerrPlungeHeight;
    scene.sky.kind = SkyKind::kBlack;
    if (!disc)
        scene.disc.reset();
    else
        scene.disc->opacity = 1, scene.disc->edge = 0;
    return scene;
}

TEST_CASE(
    "kerr plunge: round and through the horizon no ray jumps by more than the reference's, and none has another fate") {
    on_one_context([](GpuSession& session) {
        Scene scene = plunging(false);
        const auto path = CameraPath::make(scene);
        REQUIRE(path);
        const double horizon = *(*make_spacetime("kerr", scene.spacetime.parameters))->horizon_radius();
        // The frame where it is crossed: there steps of a thousandth of a frame, before and after of the film's.
        double across = 0;
        for (double width = path->frames() - 1; width > 1e-9; width *= 0.5)
            if (path->at(across + width).r > horizon) across += width;
        const auto run = [&](double from, double to, int steps, bool disc) {
            const Jumps jumps = jumps_of(session, steps, 1, false, [&](int i) {
                Scene there = plunging(disc);
                there.camera = path->at(from + (to - from) * i / steps);
                return there;
            });
            fmt::print(
                "frames {:.4f} to {:.4f}{}: {} directions, largest jump beyond the reference's {:.1e} rad, other fates "
                "{}\n",
                from, to, disc ? " with the disc" : "", jumps.judged, jumps.most, jumps.fates);
            return jumps;
        };
        const double last = path->frames() - 1;
        const int fewer = by_depth(4, 1, 1);
        const Jumps seam = run(across - 0.05 / fewer, across + 0.05 / fewer, 100 / fewer, false);
        CHECK(seam.most < kJump);
        CHECK(seam.judged > 2000 / fewer);
        CHECK(run(across - 10, last, 200 / fewer, false).most < kJump);
        CHECK(run(0, across, 60 / fewer, false).most < kJump);
        CHECK(run(across - 1, across + 1, 20 / fewer, true).most < kJump);
        // That it can fail: the frame of another time.
        Scene here = scene, there = scene;
        here.camera = path->at(across), there.camera = path->at(across + 0.1);
        CHECK(planted_jump(session, here, there) > kJump);
    });
}

TEST_CASE("kerr plunge: stations outside, on and inside the horizon are the reference's, disc and all" *
          test::costly()) {
    on_one_context([](GpuSession& session) {
        const auto path = CameraPath::make(*load_scene(plunge_file()));
        REQUIRE(path);
        // With the disc a lone pixel of sky may have no neighbours that tell how fast it moves: directions are those without it.
        AgainstReference sky("kerr plunge", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920}),
            with_disc("kerr plunge with the disc", {.place = kEveryRay_px, .of_width = 1920});
        Selection selection(3);  // of 0 to 357: sky, disc, sky, disc, sky
        for (const double frame : {0.0, 120.0, 300.0, 339.0, 341.0, 350.0, 357.0})
            for (const bool disc : {false, true}) {
                if (!selection.takes_next()) continue;
                Scene scene = plunging(disc);
                scene.camera = path->at(frame);
                scene.camera.width = by_depth(64, 96, 96), scene.camera.height = by_depth(36, 54, 54);
                (disc ? with_disc : sky).frame(session, fmt::format("frame {}", frame), scene);
            }
    });
}

}  // namespace
