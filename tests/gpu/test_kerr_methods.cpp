// The tracer of rotating holes by other steps and orders (--method mino): the default is auto's, errors fall with the step as the order has it, and
// what a scene cannot have is refused.
#include <algorithm>

#include "support/draft.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kCap = 64;                             // SPIN_MOST_STEPS
constexpr double kKerrMethodsRefineAbove_px = 1e-5;  // below every error here

Scene view(double r, double theta, double yaw) {
    Draft draft = Draft().metric("kerr", {{"spin", 0.9}}).sky(SkyKind::kBlack).by(ObserverKind::kZamo);
    draft.scene.camera.pitch = 0.1;
    return draft.place(r, theta).yaw(yaw).plane(2.0).size(96, 54);
}

Scene far_view() { return view(8, 1.4, 0); }
Scene near_view() { return view(0.7323, 1.0, 2.4); }  // 1.02 radii of the horizon
Scene outward_view() { return view(3, 1.0, 2.4); }    // of sixth order as far above rounding as any

RayFrame rays_by(GpuSession& session, const Scene& scene, const char* name) {
    session.renderer->set_method(*parse_method(name));
    return gl_ray_data(session, scene);
}

struct Fall {
    const char *name, *shorter;
    Scene (*view)();
    double p999, median;  // at least this many times smaller
};

TEST_CASE(
    "kerr methods: a shorter step lowers the errors by the order's power, and none of the default's rays reaches the "
    "cap" *
    test::costly()) {
    // 2^4 = 16 where fourth order alone is at work, 15.0 measured; third would give 8. 0.7^-6 = 8.5 of sixth, 7.4 measured in the median, fifth would
    // give 5.9; half the step meets float's rounding, as the 99.9th percentile does on the way, which falls 5.3 times.
    const Fall falls[] = {{"mino:4:0.6", "mino:4:0.3", far_view, 12, 12},
                          {"mino:6:1", "mino:6:0.7", outward_view, 4, 6.8}};
    on_one_context([&](GpuSession& session) {
        for (const Fall& fall : falls) {
            const Scene scene = fall.view();
            const ExactTrace trace = remembered(reference_trace(scene));
            const auto errors = [&](const char* name) {
                const RayMeasures m =
                    measure_rays(rays_by(session, scene, name), scene.camera, trace, 1, kKerrMethodsRefineAbove_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
                return m.sky_px;
            };
            const Spread whole = errors(fall.name), shorter = errors(fall.shorter);
            fmt::print("{} {} px, {} {} px: {:.1f} times at the 99.9th percentile, {:.1f} in the median\n", fall.name,
                       spread_text(whole), fall.shorter, spread_text(shorter), whole.p999 / shorter.p999,
                       whole.median / shorter.median);
            CHECK(whole.p999 >= fall.p999 * shorter.p999);
            CHECK(whole.median >= fall.median * shorter.median);
        }
        for (const Scene& scene : {far_view(), near_view(), view(1000, 1.2, 0), view(2, 1.2, 0.7)}) {
            const RayFrame rays = rays_by(session, scene, "mino"), usual = rays_by(session, scene, "strip");
            CHECK(mark_of(rays) == mark_of(usual));  // auto's
            int most = 0;
            for (const RayPixel& pixel : rays.pixels) most = std::max(most, pixel.steps);
            fmt::print("r = {}: {} steps at most\n", scene.camera.r, most);
            CHECK(most > 0);
            CHECK(most < kCap);
        }
    });
}

TEST_CASE("kerr methods: what a scene cannot have is refused") {
    on_every_context([](GpuSession& session) {
        const auto refused = [&](const Scene& scene, const char* name, const char* word) {
            session.renderer->set_method(*parse_method(name));
            const Status ready = session.renderer->prepare(scene);
            REQUIRE_FALSE(ready);
            CHECK(ready.error().kind == ErrorKind::kBadInput);
            CHECK_MESSAGE(ready.error().message().find(word) != std::string::npos, ready.error().message());
        };
        Scene disc = far_view(), ball = far_view();
        disc.disc.emplace(), add<BallSpec>(ball);
        for (const char* name : {"mino:4", "kerr-schild:0.1", "table", "strip:cubic"})
            for (const Scene& scene : {disc, ball}) refused(scene, name, "allowed: auto, mino");
        for (const char* name : {"mino", "mino:4", "kerr-schild:0.1"})
            refused(Scene{}, name, "for rotating holes only");
        session.renderer->set_method(*parse_method("mino:6:0.5"));
        CHECK(session.renderer->prepare(disc));
    });
}

}  // namespace
