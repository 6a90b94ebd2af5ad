// A plunge about a rotating hole as OpenGL draws it: round it and through its horizon, without a seam or a jump.
#include <algorithm>
#include <cmath>

#include "observer/path.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"
#include "support/folders.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kKerrPlungeWidth = 24, kKerrPlungeHeight = 14;
constexpr double kWinds = 0.1;  // rad a step: rays that wind turn their sky by more, and nothing follows
// What a step may add to the reference's: twice the error of a direction, float and steps of a tenth of a pixel of 1080p at most, where the
// sky turns ten times as fast as the pixel.
constexpr double kJump = 2e-4;
constexpr double kKerrPlungeRays_px = 0.05;  // px of 1080p

std::string plunge_file() { return (data_folder() / "golden/scenes/kerr-circling.toml").string(); }

struct Jumps {
    double most = 0;  // of OpenGL's directions in a step beyond the reference's, rad
    int fates = 0, judged = 0, not_finite = 0;
};

void judge(const RayFrame& gl_before, const RayFrame& gl, const RayFrame& exact_before, const RayFrame& exact,
           Jumps& jumps) {
    for (std::size_t i = 0; i < gl.pixels.size(); ++i) {
        const RayPixel& p = gl.pixels[i];
        jumps.not_finite += !std::isfinite(p.sky.x + p.sky.y + p.sky.z + p.g + p.u + p.v);
        jumps.fates += p.fate != exact.pixels[i].fate;
        if (gl_before.pixels.empty()) continue;
        const bool sky = p.fate == Fate::kEscaped && exact.pixels[i].fate == Fate::kEscaped &&
                         gl_before.pixels[i].fate == Fate::kEscaped && exact_before.pixels[i].fate == Fate::kEscaped;
        if (!sky) continue;
        const double step = angle_between(exact.pixels[i].sky, exact_before.pixels[i].sky);
        if (step > kWinds) continue;
        ++jumps.judged;
        jumps.most = std::max(jumps.most, angle_between(p.sky, gl_before.pixels[i].sky) - step);
    }
}

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
            Jumps jumps;
            RayFrame gl_before, exact_before;
            for (int i = 0; i <= steps; ++i) {
                Scene there = plunging(disc);
                there.camera = path->at(from + (to - from) * i / steps);
                RayFrame gl = gl_ray_data(session, there), exact = reference_frame(there);
                judge(gl_before, gl, exact_before, exact, jumps);
                gl_before = std::move(gl), exact_before = std::move(exact);
            }
            fmt::print(
                "frames {:.4f} to {:.4f}{}: {} directions, largest jump beyond the reference's {:.1e} rad, other fates "
                "{}\n",
                from, to, disc ? " with the disc" : "", jumps.judged, jumps.most, jumps.fates);
            CHECK(jumps.fates == 0);
            CHECK(jumps.not_finite == 0);
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
        Jumps planted;
        Scene here = scene, there = scene;
        here.camera = path->at(across), there.camera = path->at(across + 0.1);
        const RayFrame exact = reference_frame(here);
        judge(gl_ray_data(session, there), gl_ray_data(session, here), exact, exact, planted);
        CHECK(planted.most > kJump);
    });
}

TEST_CASE("kerr plunge: stations outside, on and inside the horizon are the reference's, disc and all" *
          test::costly()) {
    on_one_context([](GpuSession& session) {
        const auto path = CameraPath::make(*load_scene(plunge_file()));
        REQUIRE(path);
        Selection selection(3);  // of 0 to 357: sky, disc, sky, disc, sky
        for (const double frame : {0.0, 120.0, 300.0, 339.0, 341.0, 350.0, 357.0})
            for (const bool disc : {false, true}) {
                if (!selection.takes_next()) continue;
                Scene scene = plunging(disc);
                scene.camera = path->at(frame);
                scene.camera.width = by_depth(64, 96, 96), scene.camera.height = by_depth(36, 54, 54);
                const double finer = 1920.0 / scene.camera.width;
                const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene));
                fmt::print(
                    "frame {:<4} r = {:.5f} {:<5}: sky {:.4f}, disc {:.4f}, g {:.4f} px of 1080p; fate errors {}, "
                    "skies {}\n",
                    frame, scene.camera.r, disc ? "disc" : "sky", m.sky_px.max * finer, m.place_px.max * finer,
                    m.g_px.max * finer, m.fate_errors, m.sky_px.count);
                // With the disc a lone pixel of sky may have no neighbours that tell how fast it moves: directions are those without it.
                if (!disc) CHECK(m.sky_px.max * finer <= kKerrPlungeRays_px);
                CHECK(m.place_px.max * finer <= kKerrPlungeRays_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
            }
    });
}

}  // namespace
