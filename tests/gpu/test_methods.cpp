// Every way of tracing against the reference, and the promise of --method auto --max-error.
#include <cmath>
#include <random>
#include <vector>

#include "base/assets.h"
#include "shaderlib/frontier.h"
#include "support/gpu_session.h"
#include "support/metrics.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kMethodsWidth = 256, kMethodsHeight = 144;
constexpr double kMethodsRefineAbove_px = 1e-4;  // far below every bound here

Scene random_camera(std::mt19937& random) {
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.r = 1.0 + 0.01 * std::pow(1e5, uniform(0, 1));  // 1.01 to 1000
    scene.camera.theta = std::acos(uniform(-1, 1));
    scene.camera.yaw = uniform(-M_PI, M_PI);
    scene.camera.pitch = uniform(-1, 1);
    scene.camera.roll = uniform(-M_PI, M_PI);
    scene.camera.plane_width = std::pow(10.0, uniform(-1, 0.5));
    scene.camera.width = kMethodsWidth;
    scene.camera.height = kMethodsHeight;
    if (uniform(0, 1) < 0.3) scene.camera.velocity = {uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5)};
    if (uniform(0, 1) < 0.5) {
        scene.disc.emplace();
        scene.disc->inner = 1.5;
        scene.disc->outer = std::fmax(30, 3 * scene.camera.r);
    }
    return scene;
}

double worst_error(GpuSession& session, const Scene& scene, const ExactTrace& trace, const Method& method,
                   long long& fate_errors) {
    session.renderer->set_method(method);
    const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, trace, 1, kMethodsRefineAbove_px);
    fate_errors += m.fate_errors + m.not_finite;
    return std::fmax(m.sky_px.max, m.place_px.max);
}

TEST_CASE(
    "methods: auto keeps what it promises, for many cameras and 1, 0.1 and 0.02 px, with and without the default" *
    test::costly()) {
    const auto measured = load_frontier(assets_directory() / "frontier.csv");
    REQUIRE(measured);
    std::vector<MeasuredMethod> others;  // so that the choice is not always the same
    for (const MeasuredMethod& m : *measured)
        if (m.method.kind != MethodKind::kStrip) others.push_back(m);
    auto session = open_gpu("egl");
    if (!session) session = open_gpu("osmesa");
    REQUIRE(session);
    std::mt19937 random(30);
    long long fate_errors = 0;
    int kept = 0, refused = 0;
    const int cameras = by_depth(3, 30, 30);
    for (int i = 0; i < cameras; ++i) {
        const Scene scene = random_camera(random);
        const ExactTrace trace = remembered(reference_trace(scene));
        for (const std::vector<MeasuredMethod>* methods : {&std::as_const(*measured), &std::as_const(others)}) {
            std::vector<std::pair<Method, double>> done;
            for (const double asked : {1.0, 0.1, 0.02}) {
                const auto choice = choose_method(*methods, scene, asked);
                if (!choice) {
                    ++refused;
                    continue;
                }
                double worst = -1;
                for (const auto& [method, error] : done)
                    if (method == choice->method) worst = error;
                if (worst < 0) {
                    worst = worst_error(*session, scene, trace, choice->method, fate_errors);
                    done.emplace_back(choice->method, worst);
                }
                CAPTURE(method_name(choice->method));
                CAPTURE(scene.camera.r);
                CHECK(worst <= asked);
                ++kept;
            }
        }
    }
    fmt::print("promises kept {}, refused {}\n", kept, refused);
    CHECK(fate_errors == 0);
    CHECK(kept >= 4 * cameras);
}

TEST_CASE("methods: a tolerance that nothing meets is refused with the smallest that can be met") {
    const auto measured = load_frontier(assets_directory() / "frontier.csv");
    REQUIRE(measured);
    Scene scene;
    const auto choice = choose_method(*measured, scene, 1e-6);
    REQUIRE(!choice);
    CHECK(choice.error().kind == ErrorKind::kBadInput);
    CHECK(choice.error().message().find("allowed:") != std::string::npos);
}

// The filter of many GPUs has weights of 8 bits: the remainder R is flat enough that this costs no more than its bound.
TEST_CASE("methods: hardware filtering with weights of 8 bits, emulated") {
    const auto spacetime = spherical("schwarzschild");
    const DeflectionTable table(*spacetime);
    constexpr int kSize = 512;
    // Measured 2.4e-5: half a 256th of the step of R between nodes, and the bilinear error.
    constexpr double kBound_rad = 3e-5;
    double worst = 0;
    std::mt19937 random(8);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < 20000; ++i) {
        const double x = uniform() * kSize, y = uniform() * kSize;
        const int ix = static_cast<int>(x), iy = static_cast<int>(y);
        const double f = std::round((x - ix) * 256) / 256, g = std::round((y - iy) * 256) / 256;
        for (const bool turning : {true, false}) {
            const auto at = [&](int a, int b) {
                return turning ? table.turning_remainder(a / double(kSize), b / double(kSize))
                               : table.through_remainder(a / double(kSize), b / double(kSize));
            };
            const double filtered = (1 - g) * ((1 - f) * at(ix, iy) + f * at(ix + 1, iy)) +
                                    g * ((1 - f) * at(ix, iy + 1) + f * at(ix + 1, iy + 1));
            const double exact =
                turning ? table.turning_remainder(x / kSize, y / kSize) : table.through_remainder(x / kSize, y / kSize);
            worst = std::fmax(worst, std::fabs(filtered - exact));
        }
    }
    fmt::print("8-bit weights, {}^2: at most {:.2e} rad\n", kSize, worst);
    CHECK(worst < kBound_rad);
}

TEST_CASE("methods: a bound that tells nothing is not told") {
    const auto measured = load_frontier(assets_directory() / "frontier.csv");
    REQUIRE(measured);
    Scene scene;
    const auto reason_at = [&](double fov) {
        scene.camera.focal_distance = 1.0, scene.camera.plane_width = 2 * std::tan(0.5 * fov);
        return default_method(*measured, scene).reason;
    };
    CHECK(reason_at(1.0).find("limit 0.05") != std::string::npos);
    CHECK(reason_at(0.01).find("px is guaranteed, not the usual 0.05") != std::string::npos);
    scene.camera.r = 1e9;
    const std::string deep = reason_at(2e-8);  // filled by the hole
    CHECK(deep.find("not measured for pixels as small as these (1.6e-11 rad)") != std::string::npos);
    CHECK(deep.find("px") == std::string::npos);
}

}  // namespace
