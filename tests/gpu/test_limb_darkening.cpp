// Limb darkening of the disc as the GPU draws it: the law, and the cosine between the light and the disc's normal in the matter's frame.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/metric.h"
#include "shaderlib/preprocess.h"
#include "shaderlib/shader_source.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// The shader's law at equally spaced cosines from 0 to 1, drawn.
class DrawnLaw {
public:
    DrawnLaw() {
        const gl::VertexArray empty = gl::make_vertex_array();
        const std::string head = "#version 330 core\n";
        const std::string fragment =
            head + resolved_text("effect/limb_darkening.glsl", {}, shader_file) +
            fmt::format(
                "out vec4 colour;\nvoid main() {{ colour = vec4(limb_darkening((gl_FragCoord.x - 0.5) / {}.0)); }}\n",
                kCells);
        const gl::Program program =
            gl::make_program(head + std::string(shader_file("stage/fullscreen.vert")), fragment);
        const gl::Target target = gl::make_target(kCells + 1, 1, gl::Format::kRgba32F);
        gl::draw_fullscreen(program, empty, target.framebuffer.id(), kCells + 1, 1);
        std::vector<float> pixels(4 * (kCells + 1));
        gl::read_rgba32f(target, 0, pixels.data());
        for (std::size_t i = 0; i <= kCells; ++i) values_.push_back(pixels[4 * i]);
    }
    static constexpr std::size_t kCells = 8192;
    const std::vector<double>& values() const { return values_; }
    bool grows() const { return std::is_sorted(values_.begin(), values_.end()); }
    // Straight lines between them: 1e-7 of the cosine and less beyond 0.02.
    double cosine_of(double value) const {
        const auto above = std::upper_bound(values_.begin() + 1, values_.end() - 1, value);
        return (static_cast<double>(above - 1 - values_.begin()) + (value - above[-1]) / (above[0] - above[-1])) /
               kCells;
    }

private:
    std::vector<double> values_;
};

constexpr double kFit = 7e-5;  // of the shader's six terms: 6.3e-5 by itself

TEST_CASE("limb darkening: the shader's law is the reference's at every angle") {
    const auto metric = reference::make_metric({"schwarzschild", {}});
    REQUIRE(metric);
    DiscSpec plain;
    plain.emission = DiscEmission::kThermal;
    DiscSpec darkened = plain;
    darkened.effects.limb_darkening = true;
    LightSpec at_rest;
    at_rest.doppler = false;
    const reference::DiscLight with(**metric, darkened, at_rest), without(**metric, plain, at_rest);
    on_one_context([&](GpuSession&) {
        const DrawnLaw law;
        CHECK(law.grows());
        double worst = 0;
        for (std::size_t i = 0; i <= DrawnLaw::kCells; i += 8) {
            const double cosine = static_cast<double>(i) / DrawnLaw::kCells;
            const reference::PhotonAtDisc photon{8.0, 0.0, std::sqrt((1 - cosine) * (1 + cosine))};
            const double exact = with.colour(photon, 1).y / without.colour(photon, 1).y;
            worst = std::max(worst, std::abs(law.values()[i] / exact - 1));
        }
        fmt::print("limb darkening: the shader's law within {:.2g} of the reference's\n", worst);
        CHECK(worst < kFit);
    });
}

struct Switches {
    bool doppler = true, gravity = true, lensing = true;
};
struct LimbDarkeningView {
    SpacetimeSpec spacetime;
    double theta_deg;
    Vec3 velocity;
    Switches part;
    double opacity;
    DiscLean lean{};
};

Scene scene_of(const LimbDarkeningView& view) {
    Scene scene;
    scene.picture.refine = false;
    scene.spacetime = view.spacetime;
    if (view.spacetime.metric != "schwarzschild") scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = 40;
    scene.camera.theta = view.theta_deg * M_PI / 180;
    scene.camera.velocity = view.velocity;
    scene.camera.width = 640, scene.camera.height = 360;
    scene.camera.focal_distance = 1, scene.camera.plane_width = 0.8;
    scene.sky.kind = SkyKind::kBlack;
    DiscSpec& disc = scene.disc.emplace();
    disc.emission = DiscEmission::kThermal;
    disc.inner = 1.4, disc.outer = 14, disc.opacity = view.opacity;
    disc.effects.limb_darkening = true;
    if (view.lean.tilt != 0) disc.lean = view.lean, disc.inner = 3;  // where no circle of it outruns light
    scene.light.doppler = view.part.doppler, scene.light.gravity = view.part.gravity,
    scene.light.lensing = view.part.lensing;
    return scene;
}

// What one view's pixels are off by.
struct LimbDarkeningWorst {
    double cosine = 0, light = 0, least = 1;
    int pixels = 0, views = 0;
};

void measure(GpuSession& session, const DrawnLaw& law, const LimbDarkeningView& view, LimbDarkeningWorst& worst) {
    constexpr double kCosine = 1e-5;  // of a cosine, where the law tells it: as g's promise
    constexpr double kSlant = 0.02;   // below it the cosine's own error is measured by the light alone
    // And what 1e-5 of the cosine makes of it at a slant: three times as much at most, and of g.
    constexpr double kSameLight = kFit + 5e-5;
    Scene scene = scene_of(view);
    const Image<float> picture = picture_of(session, scene);
    scene.disc->effects.limb_darkening = false;
    const Image<float> plain = picture_of(session, scene);
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const reference::DiscLight light(tracer->matter(), *scene.disc, scene.light);
    scene.disc->effects.limb_darkening = true;
    const reference::DiscLight darkened(tracer->matter(), *scene.disc, scene.light);
    ++worst.views;
    std::mt19937 random(5);
    for (int i = 0; i < by_depth(250, 1500, 1500); ++i) {
        const int x = static_cast<int>(random() % 640), y = static_cast<int>(random() % 360);
        const reference::RayPtr ray = tracer->ray(x + 0.5, y + 0.5);
        const auto hits = tracer->disc_hits(*ray, 2);
        if (hits.size() != 1) continue;  // where the disc is seen through there is more than one light
        const double r = std::hypot(hits[0].x, hits[0].y);
        if (r < light.innermost() * 1.02 || r > 13.8) continue;  // dark; the rim
        bool whole = true;
        for (const auto& [dx, dy] : {std::pair{-1.5, 0.0}, {1.5, 0.0}, {0.0, -1.5}, {0.0, 1.5}}) {
            const reference::RayPtr other = tracer->ray(x + 0.5 + dx, y + 0.5 + dy);
            const auto beside = tracer->disc_hits(*other, 2);
            whole = whole && beside.size() == 1 && std::abs(std::hypot(beside[0].x, beside[0].y) - r) < 1.0;
        }
        if (!whole) continue;
        const reference::PhotonAtDisc photon{r, hits[0].l, hits[0].climb, hits[0].cosine, hits[0].across};
        const double ratio = static_cast<double>(picture.at(x, y)[1]) / plain.at(x, y)[1],
                     cosine = light.cosine(photon);
        const double g = ray->g * light.shift(photon).seen(scene.light);
        const double error = std::abs(ratio / (darkened.colour(photon, g).y / light.colour(photon, g).y) - 1);
        CAPTURE(view.spacetime.metric);
        CAPTURE(view.theta_deg);
        CAPTURE(r);
        CAPTURE(cosine);
        CHECK(error <= kSameLight);
        worst.light = std::max(worst.light, error);
        worst.least = std::min(worst.least, cosine);
        ++worst.pixels;
        if (cosine < kSlant) continue;
        const double off = std::abs(law.cosine_of(ratio) - cosine);
        CHECK(off <= kCosine);
        worst.cosine = std::max(worst.cosine, off);
    }
}

TEST_CASE("limb darkening: cosine and light are the reference's, at rest and moving, whole and with a part left out" *
          test::costly()) {
    const SpacetimeSpec schwarzschild{"schwarzschild", {}}, kerr{"kerr", {{"spin", 0.9}}};
    const Vec3 rest{0, 0, 0}, moving{0.2, 0.3, -0.1};
    std::vector<LimbDarkeningView> views;
    for (const double theta : {3.0, 85.0, 60.0, 120.0})
        for (const Vec3 velocity : {moving, rest}) views.push_back({schwarzschild, theta, velocity, {}, 1.0});
    for (const Switches part : {Switches{false, true, true},
                                {true, false, true},
                                {false, false, true},
                                {true, true, false},
                                {false, true, false},
                                {true, false, false},
                                {false, false, false}})
        views.push_back({schwarzschild, 70.0, moving, part, 1.0});
    views.push_back({schwarzschild, 70.0, rest, {}, 0.6});
    for (const double theta : {30.0, 75.0, 100.0})
        for (const Vec3 velocity : {moving, rest}) views.push_back({kerr, theta, velocity, {}, 1.0});
    for (const double tilt : {0.5, 2.0}) views.push_back({kerr, 60.0, moving, {}, 1.0, {tilt, 0.7}});
    on_one_context([&](GpuSession& session) {
        const DrawnLaw law;
        LimbDarkeningWorst worst;
        Selection selection(3);  // of each kind one at least
        for (const LimbDarkeningView& view : views)
            if (selection.takes_next()) measure(session, law, view, worst);
        fmt::print(
            "limb darkening in {} pixels of {} views: cosine within {:.2g}, light within {:.2g}, least cosine {:.3f}\n",
            worst.pixels, worst.views, worst.cosine, worst.light, worst.least);
        CHECK(worst.pixels > by_depth(200, 5000, 5000));
        CHECK(worst.least < 0.15);
    });
}

// Far out, where light is straight and matter at rest, a ring's light goes as the law says alone: with the cosine of the camera's own polar
// angle, by Chandrasekhar's printed table, over what it is without.
TEST_CASE("limb darkening: all light of a far ring is the printed table's at each inclination") {
    struct Printed {
        double cosine, law;
    };
    constexpr double kPrinted = 1e-4;  // the fit, the table's digits, and the ring's width over its distance
    on_one_context([&](GpuSession& session) {
        const auto all_light = [&](double cosine, bool darkened) {
            Scene scene;
            scene.picture.refine = false;
            scene.camera.r = 1e5;
            scene.camera.theta = std::acos(cosine);
            scene.camera.width = scene.camera.height = 256;
            scene.camera.focal_distance = 1, scene.camera.plane_width = 2.4e-3;
            scene.sky.kind = SkyKind::kBlack;
            scene.disc.emplace().emission = DiscEmission::kThermal;
            scene.disc->inner = 90, scene.disc->outer = 110, scene.disc->brightness = 1e4;
            scene.disc->effects.limb_darkening = darkened;
            scene.light.doppler = scene.light.gravity = scene.light.lensing = false;
            const Image<float> picture = picture_of(session, scene);
            double sum = 0;
            for (int y = 0; y < 256; ++y)
                for (int x = 0; x < 256; ++x) sum += picture.at(x, y)[1];
            return sum;
        };
        const double face_on = all_light(1.0, false);
        REQUIRE(face_on > 0);
        for (const auto [cosine, law] : {Printed{1.0, 1.26938}, {0.9, 1.18947}, {0.5, 0.86637}, {0.2, 0.61439}}) {
            const double plain = all_light(cosine, false), darkened = all_light(cosine, true);
            fmt::print("ring at cosine {}: light over face-on {:.5f}, darkened over plain {:.5f}, printed {:.5f}\n",
                       cosine, plain / face_on, darkened / plain, law);
            CHECK(darkened / plain == doctest::Approx(law).epsilon(kPrinted));
        }
    });
}

}  // namespace
