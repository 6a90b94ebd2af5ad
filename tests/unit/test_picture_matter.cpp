// Matter's light with its derivatives (src/gradient) against pictures of the reference, which shares no code with it, and against differences of its own
// values, which have no grain; the flux against differences of its own, across the critical curve.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "changed_scene.h"
#include "gradient/matter_law.h"
#include "gradient/picture_matter.h"
#include "reference/emission.h"
#include "reference/reference.h"
#include "scene/projection.h"
#include "support/costly.h"
#include "support/depth.h"

namespace {

using namespace nullscope;
using test::change_scene;

struct MatterCase {
    const char* name;
    const char* metric;
    MetricParameters parameters;
    void (*change)(Scene&);
};

Scene matter_scene(const MatterCase& of) {
    Scene scene;
    scene.spacetime = {of.metric, of.parameters};
    scene.sky.kind = SkyKind::kBlack;
    scene.object.mass_suns = 4e6;
    CameraSpec& camera = scene.camera;
    camera.r = 40.0, camera.theta = 1.1, camera.phi = 0.3, camera.yaw = 0.02, camera.pitch = -0.01, camera.roll = 0.3;
    camera.width = 6, camera.height = 4;
    set_field_of_view(camera, 0.45);
    scene.medium.emplace();
    of.change(scene);
    return scene;
}

// A disc of electrons that spirals in; it is brighter on one side.
void spiral(Scene& scene) {
    MediumSpec& m = *scene.medium;
    m.kind = MediumKind::kFormula, m.emission = MediumEmission::kSynchrotron, m.outer = 9.0;
    m.formulas = {
        "3e6*r^-1.5*exp(-2*(z/r)^2)*(1 + 0.4*x/r)", "6e10*r^-0.8", "30/r", "-0.2/r", "0.05*z/r", "0.6/sqrt(r)"};
}

const MatterCase kMatterCases[] = {
    {"flow, thick", "kerr", MetricParameters({{"spin", 0.9}}),
     [](Scene& s) {
         MediumSpec& m = *s.medium;
         m.kind = MediumKind::kFlow, m.flow = {3.0, 2.0, 0.8}, m.spectral_index = 0.7, m.absorption = 1e4;
     }},
    {"synchrotron in a field of one direction, moving camera", "kerr", MetricParameters({{"spin", -0.6}}),
     [](Scene& s) {
         spiral(s), s.medium->field_direction = FieldDirection::kSouth;
         s.camera.velocity = {0.1, -0.02, 0.03};
     }},
    {"synchrotron", "schwarzschild", {}, spiral},
    {"bremsstrahlung", "kerr-newman", MetricParameters({{"spin", 0.5}, {"charge", 0.4}}),
     [](Scene& s) {
         MediumSpec& m = *s.medium;
         m.kind = MediumKind::kFormula, m.emission = MediumEmission::kBremsstrahlung, m.outer = 8.0;
         m.formulas = {"1e9*exp(-r)", "1e9/r", "0", "0", "0", "0.3"};
     }},
};

SkyCube black_sky() {
    SkyCube sky;
    sky.size = 4;
    for (Image<float>& face : sky.faces) face = Image<float>(4, 4, 3);
    return sky;
}

TEST_CASE("picture matter: values as the reference has them, derivatives as their differences") {
    constexpr double kMarch = 2e-3;  // of the light: what the reference's midpoint rule is off by in a ray
    constexpr double kDifferences =
        2e-4;  // of derivatives, or of the light where that is more: the steps' tolerance over their length
    const std::size_t every = test::by_depth<std::size_t>(6, 2, 1);
    for (const MatterCase& of : kMatterCases) {
        CAPTURE(of.name);
        const Scene scene = matter_scene(of);
        const auto names = parameter_names(scene, DerivativesOf::kLight);
        const auto light = PictureMatter::make(scene, {names.begin(), names.end()});
        REQUIRE_MESSAGE(light, (light ? "" : light.error().message()));
        const auto picture = reference::render_frame(scene, black_sky(), {}, 1);
        REQUIRE(picture);
        const double brightest = *std::ranges::max_element(picture->data);
        REQUIRE(brightest > 0);
        double worst_value = 0, worst = 0, most_by = 0;
        std::string where;
        for (std::size_t i = 0; i < 24; i += every) {
            const std::size_t pixel = (7 * i + 8) % 24;  // from about the middle
            const double x = 0.5 + static_cast<double>(pixel % 6), y = 0.5 + static_cast<double>(pixel / 6);
            const auto ray = (*light)->at(x, y, 1, 0, 0.01 * brightest);
            const double right = picture->data[pixel * static_cast<std::size_t>(picture->channels)];
            worst_value = std::max(worst_value, std::fabs(ray.light - right) / std::max(right, 0.01 * brightest));
            for (std::size_t k = 0; k < names.size(); ++k) {
                constexpr double kStep = 2e-4;
                std::array<double, 4> there{};
                for (const std::size_t side : {0, 1, 2, 3}) {
                    Scene other = scene;
                    change_scene((*light)->keys()[k].kind, std::array{-kStep, -0.5 * kStep, 0.5 * kStep, kStep}[side],
                                 other);
                    const auto moved = PictureMatter::make(other, {});
                    REQUIRE(moved);
                    there[side] = (*moved)->at(x, y, 1, 0, 0.01 * brightest).light;
                }
                const double wide = (there[3] - there[0]) / (2 * kStep), half = (there[2] - there[1]) / kStep,
                             slope = (4 * half - wide) / 3;
                // The differences' own error is less than a tenth of what the extrapolation changed.
                const double off = (std::fabs(ray.by[k] - slope) - 0.1 * std::fabs(half - wide)) /
                                   std::max({std::fabs(slope), ray.light, 0.01 * brightest});
                most_by = std::max(most_by, std::fabs(slope));
                if (!(off <= worst))
                    worst = std::isnan(off) ? 1 : off,
                    where = fmt::format("{} at {}, {}: {:.9g} by differences {:.9g}", names[k], x, y, ray.by[k], slope);
            }
        }
        MESSAGE(
            fmt::format("{}: light within {:.2g}, derivatives within {:.2g}, {}", of.name, worst_value, worst, where));
        CHECK(worst_value < kMarch);
        CHECK(worst < kDifferences);
        CHECK(most_by > 0);
    }
}

TEST_CASE("picture matter: laws of emission as the reference has them") {
    for (const double temperature : {2e9, 3e10, 1e12})
        for (const double nu : {4e10, 2.3e11, 1e12}) {
            CAPTURE(temperature);
            CAPTURE(nu);
            const Number n(1e5), t = Number::variable(temperature, kSeedR), b(30.0), sine(0.6), f(nu);
            const auto same = [&](const Number& ours, double (*theirs)(double temperature, double nu)) {
                const double h = 1e-3 * temperature;
                const double wide = (theirs(temperature + h, nu) - theirs(temperature - h, nu)) / (2 * h),
                             half = (theirs(temperature + h / 2, nu) - theirs(temperature - h / 2, nu)) / h;
                CHECK(ours.value == doctest::Approx(theirs(temperature, nu)).epsilon(1e-9));
                CHECK(ours.d[kSeedR] == doctest::Approx((4 * half - wide) / 3).epsilon(1e-7));
            };
            same(matter_law::synchrotron_at(n, t, b, sine, f),
                 [](double k, double hz) { return reference::synchrotron_at(1e5, k, 30, 0.6, hz); });
            same(matter_law::synchrotron_mean(n, t, b, f),
                 [](double k, double hz) { return reference::synchrotron_mean(1e5, k, 30, hz); });
            same(matter_law::planck(t, f), reference::planck);
        }
}

// Pixels' own derivatives go to infinity at the critical curve, with both signs: what is left out there would be missed.
TEST_CASE("picture matter: the flux's derivatives are its differences" * test::costly()) {
    const auto flux = [&](double spin, const MatterFluxRule& rule) {
        Scene scene = matter_scene(kMatterCases[0]);
        scene.spacetime.parameters["spin"] = spin;
        const auto light = PictureMatter::make(scene, {"spin", "camera.phi"});
        REQUIRE(light);
        const auto found = flux_gradient(**light, rule);
        REQUIRE(found);
        return *found;
    };
#ifdef NULLSCOPE_SANITIZED  // 13 times slower, and it is memory that is looked at: of few places, and no differences
    const FluxGradient found = flux(0.9, {1, 10.0});
    CHECK(found.flux > 0);
#else
    constexpr double kSame = 3e-3;  // the spokes' tolerance
    constexpr double kStep = 0.01;
    const MatterFluxRule rule{4, 0.3};
    const FluxGradient found = flux(0.9, rule);
    const double slope = (flux(0.9 + kStep, rule).flux - flux(0.9 - kStep, rule).flux) / (2 * kStep);
    MESSAGE(fmt::format("{:.8g} by differences {:.8g}, {} rays", found.by[0], slope, found.rays));
    CHECK(std::fabs(found.by[0] - slope) < kSame * std::fabs(slope));
    CHECK(std::fabs(found.by[1]) < 1e-9 * found.flux);
#endif
}

TEST_CASE("picture matter: what has no derivatives is told") {
    const auto refused = [](void (*change)(Scene&), const char* key) {
        CAPTURE(key);
        Scene scene = matter_scene(kMatterCases[2]);
        change(scene);
        const auto light = PictureMatter::make(scene, {"camera.r"});
        REQUIRE(!light);
        CHECK(light.error().key == key);
        CHECK(!light.error().allowed.empty());
    };
    refused([](Scene& s) { s.medium->kind = MediumKind::kGas; }, "medium.kind");
    refused([](Scene& s) { s.medium->kind = MediumKind::kJet; }, "medium.kind");
    refused([](Scene& s) { s.medium->emission = MediumEmission::kBlackBody; }, "medium.emission");
    refused([](Scene& s) { s.medium->electrons.kind = ElectronKind::kKappa; }, "medium.electrons");
    refused([](Scene& s) { s.medium->height = 2; }, "medium.height");
    refused([](Scene& s) { s.medium->formulas.density = "1 + sin(t)"; }, "medium.density");
    refused([](Scene& s) { s.medium->formulas.density = "1 + noise(x, y, z)"; }, "medium");
    refused([](Scene& s) { s.medium->bands_GHz = {86, 230}; }, "medium.frequency");
    refused([](Scene& s) { s.camera.observer = ObserverKind::kRain; }, "camera.observer");
}

}  // namespace
