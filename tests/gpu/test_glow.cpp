// Bodies that shine by their heat: the driver's light and g of them against the reference's.
#include <algorithm>
#include <cmath>

#include "base/assets.h"
#include "command/capture_layers.h"
#include "reference/reference.h"
#include "support/depth.h"
#include "support/draft.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"

using namespace nullscope;
using namespace nullscope::test;

namespace {

Body hot_body(BodyShape shape, double kelvin) {
    Body body;
    body.shape = std::move(shape);
    body.material.temperature_K = kelvin, body.material.colour = {1, 1, 1};
    return body;
}

struct Glowing {
    const char* name;
    Scene scene;
};

Scene about(const char* metric, double spin, std::vector<Body> bodies) {
    Draft draft;
    draft.metric(metric).place(15, 1.2).size(48, 27).plane(0.9).sky(SkyKind::kBlack).at_time(7);
    if (spin != 0) draft.spin(spin).by(ObserverKind::kZamo);
    Scene scene = draft;
    scene.picture.refine = false;
    scene.bodies = std::move(bodies);
    return scene;
}

// With two caps, one of them over the edge of the other.
Scene turning(Scene scene) {
    scene.bodies.front().material.limb = 0.4;
    scene.caps = {{.colatitude = 1.1, .azimuth = -0.6, .radius = 0.7, .temperature_K = 9000},
                  {.colatitude = 1.9, .azimuth = -0.2, .radius = 0.4, .temperature_K = 4500, .colour = {1, 0.5, 0.2}}};
    return scene;
}

std::vector<Glowing> glowing_scenes() {
    const BallSpec circling{.position = {4, 0, 0}, .radius = 1, .motion = BallMotion::kOrbit},
        falling{.position = {0, -5, 1}, .radius = 1, .motion = BallMotion::kGeodesic, .velocity = {0, 0, 0.2}},
        path{.position = {},
             .radius = 1,
             .motion = BallMotion::kPath,
             .x = "5*cos(0.1*t)",
             .y = "1 + 0*t",
             .z = "3*sin(0.1*t)"};
    const SphereSpec pulse{.radius = 1.9, .amplitude = 0.2, .period = 30};
    std::vector<Glowing> all = {
        {"falls and pulsates",
         about("schwarzschild", 0,
               {hot_body(falling, 9000), hot_body(pulse, 4000), hot_body(BallSpec{{0, 5, 1}, 1}, 5000)})},
        {"circles a charge", about("reissner-nordstrom", 0, {hot_body(circling, 6000)})},
        {"circles about a rotating hole", about("kerr", 0.9, {hot_body(circling, 6000), hot_body(path, 7000)})},
        {"pulsates about a rotating hole",
         about("kerr", -0.9, {hot_body(pulse, 5000), hot_body(CylinderSpec{5, 7, 0.4}, 5000)})},
        {"turns", turning(about("schwarzschild", 0, {hot_body(SphereSpec{.radius = 2.5, .spin_rate = 0.15}, 6000)}))},
        {"turns about a rotating hole",
         turning(about("kerr", 0.7, {hot_body(SphereSpec{.radius = 2.5, .spin_rate = -0.15}, 6000)}))},
        {"in flat space", about("minkowski", 0, {hot_body(path, 6000)})}};
    for (const int off : {0, 1, 2}) {
        Scene scene = about("schwarzschild", 0, {hot_body(circling, 6000)});
        (off == 0 ? scene.light.lensing : off == 1 ? scene.light.doppler : scene.light.gravity) = false;
        scene.light.bolometric = off == 1;
        all.push_back({off == 0 ? "straight light" : off == 1 ? "without doppler" : "without gravity", scene});
    }
    return all;
}

TEST_CASE("glow: the light of bodies is the reference's" * test::costly()) {
    constexpr double kLight = 5e-4;  // relative: a float's place, and twice that of the velocity by differences of it
    constexpr double kEdges = 0.3;   // of the lit pixels: rims are covered in part, in the reference's one ray not
    Selection selection(3);
    on_one_context([&](GpuSession& session) {
        for (const auto& [name, scene] : glowing_scenes()) {
            if (!selection.takes_next()) continue;
            CAPTURE(std::string(name));
            const auto sky = build_sky(scene.sky, assets_directory(), 16);
            REQUIRE(sky);
            const auto exact = reference::render_frame(scene, *sky, {}, 1);
            REQUIRE(exact);
            const Image<float> picture = picture_of(session, scene);
            Scene dull = scene;
            for (Body& body : dull.bodies) body.material.temperature_K.reset();
            const Image<float> other = picture_of(session, dull);
            const auto [off, changed] = lit_against(*exact, 0, picture, other, 0.02);
            REQUIRE(off.size() > 25);
            const double most = off[static_cast<std::size_t>((1 - kEdges) * static_cast<double>(off.size()))];
            fmt::print("glow: {}: {} lit pixels, median {:.1e}, within rims {:.1e}, changed by heat {}\n", name,
                       off.size(), off[off.size() / 2], most, changed);
            CHECK(most < kLight);
            CHECK(changed > 10);
        }
    });
}

// Of what does not move nobody asks for light's times: the text of rays' depths, which have a body's g, then has no other includes before glow's.
TEST_CASE(
    "glow: layers of a still body that glows have its light, without light's times, in planes and about a rotating "
    "hole" *
    test::costly()) {
    on_one_context([](GpuSession& session) {
        constexpr double kLayers = 1e-5;  // of the light: rounding of float sums
        for (const auto& [metric, spin] : {std::pair{"schwarzschild", 0.0}, {"kerr", 0.9}}) {
            CAPTURE(std::string(metric));
            const Scene scene = about(metric, spin, {hot_body(BallSpec{.position = {0, 4, 1}, .radius = 1.5}, 5000)});
            const auto drawn = cli::capture_layers(session, scene, nullptr);
            REQUIRE_MESSAGE(drawn, drawn.error().message());
            const PictureLayers& layers = drawn->layers;
            const Image<float> picture = picture_of(session, scene);
            double most = 0, lit = 0;
            for (std::size_t i = 0; i < picture.data.size(); ++i) {
                double sum = 0;
                for (const LayerImage& layer : layers.each) sum += layer.light.data[i];
                most = std::max(most, std::fabs(sum - picture.data[i])), lit += picture.data[i] > 0.01;
            }
            int shifted = 0;  // by the body's own g
            for (const float g : drawn->depths.g) shifted += g > 0.5F && g < 0.999F;
            CHECK(shifted > 20);
            CHECK(lit > 50);
            CHECK(most < kLayers);
        }
    });
}

}  // namespace
