// A disc's light with its derivatives (src/gradient) against the reference, which shares no code with it: values ray by ray, derivatives against its
// differences; fluxes against differences of their own, whose values the reference's picture gives too.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "changed_scene.h"
#include "gradient/formula_number.h"
#include "gradient/picture_flux.h"
#include "known_light.h"
#include "light/black_body.h"
#include "scene/projection.h"
#include "support/costly.h"
#include "support/depth.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using test::change_scene;
using test::KnownLight;

struct LitCase {
    const char* name;
    const char* metric;
    MetricParameters parameters;
    void (*change)(Scene&) = [](Scene&) {};
    double bound = 1e-6;  // of derivatives, of the largest or of what the light is
};

Scene lit_scene(const LitCase& of) {
    Scene scene;
    scene.spacetime = {of.metric, of.parameters};
    scene.sky.kind = SkyKind::kBlack;
    CameraSpec& camera = scene.camera;
    camera.r = 20.0, camera.theta = 1.2, camera.phi = 0.3, camera.yaw = 0.02, camera.pitch = -0.01, camera.roll = 0.3;
    camera.width = 24, camera.height = 16;
    set_field_of_view(camera, 1.0);
    DiscSpec disc;
    disc.inner = 1.7, disc.outer = 9.0, disc.edge = 0.1, disc.opacity = 0.8, disc.brightness = 1.3;
    disc.emission = DiscEmission::kThermal, disc.temperature_K = 5000.0;
    disc.material.texture = TextureKind::kPlain;
    scene.disc = disc;
    of.change(scene);
    return scene;
}

// Of 1/r to 4 r_s, 1/r^3 from there.
std::filesystem::path table_of_light() {
    static const TemporaryFolder folder("light-table");
    const std::filesystem::path file = folder.path / "light.csv";
    std::ofstream rows(file);
    for (int i = 0; i <= 64; ++i) {
        const double r = 1.5 + 0.125 * i;
        rows << fmt::format("{:.17g}, {:.17g}\n", r, r < 4 ? 1 / r : 16 / (r * r * r));
    }
    return file;
}

void with_power_law(Scene& scene) {
    scene.disc->emissivity.by = Emissivity::kPowerLaw;
    scene.disc->emissivity.powers = {2.5, 2.5, 2.5};
}

const LitCase kLitCases[] = {
    {"accretion, moving camera",
     "schwarzschild",
     {},
     [](Scene& s) {
         s.camera.velocity = {0.1, -0.2, 0.3};
     }},
    {"power law that leans, formula", "reissner-nordstrom", MetricParameters({{"charge", 0.8}}),
     [](Scene& s) {
         with_power_law(s);
         s.disc->lean = {0.3, 0.4, 0.0};
         s.disc->material.texture = TextureKind::kFormula;
         s.disc->material.formula = "0.5 + 0.4*sin(12*v)*x/length(x, y)";
     }},
    {"accretion", "kerr", MetricParameters({{"spin", 0.7}}), [](Scene&) {}, 1e-4},
    {"power law within the last circle, retrograde, bolometric", "kerr", MetricParameters({{"spin", 0.5}}),
     [](Scene& s) {
         with_power_law(s);
         s.disc->sense = OrbitSense::kRetrograde;
         s.light.bolometric = true, s.camera.observer = ObserverKind::kZamo;
     },
     1e-4},
    {"a table, thin", "kerr", MetricParameters({{"spin", 0.7}}),
     [](Scene& s) {
         s.disc->emissivity.by = Emissivity::kTable, s.disc->emissivity.file = table_of_light();
         s.disc->material.texture = TextureKind::kImage;  // none of its own: even
         s.disc->opacity = 0.01;
     },
     1e-4},
    {"accretion by mass and rate", "kerr-newman", MetricParameters({{"spin", 0.5}, {"charge", 0.4}}),
     [](Scene& s) {
         s.disc->accretion = AccretionSpec{1e8, 0.3};
     },
     1e-4},
};

double step_of(ParameterKind kind) { return kind == ParameterKind::kTemperature ? 20.0 : 1e-3; }

constexpr double kOffEdge = 1.0;  // px, where differences are taken: steps move rims by some hundredths
constexpr double kSameLight = 1e-8;

std::vector<std::array<double, 2>> lit_places(const PictureLight& light, std::size_t most) {
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < 400 && places.size() < most; ++i) {  // spread evenly over the picture
        const double x = 24 * std::fmod(0.5 + 0.7548776662 * i, 1.0), y = 16 * std::fmod(0.5 + 0.5698402910 * i, 1.0);
        const auto ray = light.at(x, y);
        if (length(ray.light) > 1e-3 && ray.off_edge > kOffEdge) places.push_back({x, y});
    }
    return places;
}

TEST_CASE("picture light: values and derivatives as the reference has them") {
    const std::size_t places_asked = test::by_depth<std::size_t>(3, 20, 100);
    for (const LitCase& of : kLitCases) {
        CAPTURE(of.name);
        const Scene scene = lit_scene(of);
        const auto names = parameter_names(scene, DerivativesOf::kLight);
        const std::vector<std::string> keys(names.begin(), names.end());
        const auto light = PictureLight::make(scene, keys);
        REQUIRE_MESSAGE(light, (light ? "" : light.error().message()));
        const auto places = lit_places(**light, places_asked);
        REQUIRE(places.size() == places_asked);
        const KnownLight known(scene);
        std::vector<PictureLight::Ray> rays;
        double worst_value = 0, worst = 0;
        std::string where;
        for (const auto& [x, y] : places) {
            rays.push_back((*light)->at(x, y));
            const Vec3 right = known.at(x, y);
            worst_value = std::max(worst_value, length(rays.back().light - right) / length(right));
        }
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const ParameterKind kind = (*light)->keys()[k].kind;
            const double h = step_of(kind);
            std::vector<std::array<Vec3, 4>> moved(places.size());
            for (std::size_t side = 0; side < 4; ++side) {
                Scene other = scene;
                change_scene(kind, std::array{-h, -0.5 * h, 0.5 * h, h}[side], other);
                const KnownLight there(other);
                for (std::size_t i = 0; i < places.size(); ++i) moved[i][side] = there.at(places[i][0], places[i][1]);
            }
            for (std::size_t i = 0; i < places.size(); ++i) {
                const auto& m = moved[i];
                const Vec3 wide = (m[3] - m[0]) / (2 * h), half = (m[2] - m[1]) / h, slope = (4 * half - wide) / 3;
                const double unit = kind == ParameterKind::kTemperature ? 1e-3 : 1.0;
                const double size = std::max(length(slope), unit * length(rays[i].light));
                // The differences' own error is less than a tenth of what the extrapolation changed.
                const double off = (length(rays[i].by[k] - slope) - 0.1 * length(half - wide)) / size;
                if (off > worst || std::isnan(off))
                    worst = std::isnan(off) ? 1 : off,
                    where = fmt::format("{} at {}, {}: {:.9g} by differences {:.9g}", keys[k], places[i][0],
                                        places[i][1], rays[i].by[k].y, slope.y);
            }
        }
        MESSAGE(fmt::format("{} {}: {} keys, {} places, light within {:.2g}, derivatives within {:.2g}, {}", of.metric,
                            of.name, keys.size(), places.size(), worst_value, worst, where));
        CHECK(worst_value < kSameLight);
        CHECK(worst < of.bound);
    }
}

Scene flux_scene() {
    Scene scene = lit_scene({"", "schwarzschild", {}});
    scene.camera.theta = 0.9;
    scene.disc->edge = 0, scene.disc->outer = 6, scene.disc->inner = 2.5;
    with_power_law(scene);
    return scene;
}

// A disc with sharp rims: what the pixels' own derivatives leave out is what the rims sweep over.
TEST_CASE("picture flux: turning the picture changes nothing, wider rims add their light" * test::costly()) {
    const auto light = PictureLight::make(
        flux_scene(), {"camera.roll", "camera.phi", "disc.brightness", "disc.outer", "camera.theta"});
    REQUIRE(light);
    const auto found = flux_gradient(**light, {6, 0.02});
    REQUIRE(found);
    const double flux = found->flux;
    CHECK(std::fabs(found->by[0]) < 2e-4 * flux);
    CHECK(std::fabs(found->by[1]) < 1e-9 * flux);
    CHECK(found->by[2] == doctest::Approx(flux / 1.3).epsilon(1e-9));
    for (const std::size_t key : {3, 4}) {
        constexpr double kStep = 0.01;
        std::array<double, 2> there{};
        for (const int side : {0, 1}) {
            Scene other = flux_scene();
            (key == 3 ? other.disc->outer : other.camera.theta) += side == 0 ? -kStep : kStep;
            const auto moved = PictureLight::make(other, {});
            REQUIRE(moved);
            const auto sum = flux_gradient(**moved, {6, 0.02});
            REQUIRE(sum);
            there[static_cast<std::size_t>(side)] = sum->flux;
        }
        CHECK(found->by[key] == doctest::Approx((there[1] - there[0]) / (2 * kStep)).epsilon(2e-3));
    }
}

TEST_CASE("picture light: what has no derivatives is told") {
    const auto refused = [](void (*change)(Scene&), const char* key) {
        CAPTURE(key);
        Scene scene = lit_scene({"", "kerr", MetricParameters({{"spin", 0.5}})});
        change(scene);
        const auto light = PictureLight::make(scene, {"spin"});
        REQUIRE(!light);
        CHECK(light.error().key == key);
        CHECK(!light.error().allowed.empty());
    };
    refused([](Scene& s) { s.disc.reset(); }, "disc");
    refused([](Scene& s) { s.disc->emission = DiscEmission::kImage; }, "disc.emission");
    refused([](Scene& s) { s.disc->material.texture = TextureKind::kImage, s.disc->image = "disc.png"; },
            "disc.texture");
    refused([](Scene& s) { s.disc->emissivity.by = Emissivity::kLamp; }, "disc.emissivity");
    refused([](Scene& s) { s.disc->effects.limb_darkening = true; }, "disc.limb_darkening");
    refused([](Scene& s) { s.camera.observer = ObserverKind::kRain; }, "camera.observer");
    refused([](Scene& s) { s.camera.projection = Projection::kFisheye; }, "camera.projection");
    refused([](Scene& s) { s.camera.r = 0.97; }, "camera.r");
    const auto light = PictureLight::make(lit_scene({"", "kerr", MetricParameters({{"spin", 0.5}})}), {"disc.powers"});
    REQUIRE(!light);
    CHECK(light.error().what.find("disc.powers") != std::string::npos);
}

TEST_CASE("picture light: formulas in dual numbers have their values and slopes") {
    using Two = Dual<double, 2>;
    for (const char* text :
         {"x^3*y - 2/(1 + x)", "exp(-7*x)*smoothstep(0, 0.9, y)", "atan(y, x) + atan(x)",
          "mix(x, y, 0.3) + abs(x - 2*y)", "sqrt(x^1.5)*log(y)", "min(x, y)*max(2*x, y)", "clamp(3*x, 0.1, 2)",
          "mod(5*x, 1.3)", "tan(x)*length(x, y, 1)", "step(0.2, x)*cos(y) + floor(7*y)", "x^-2"}) {
        CAPTURE(text);
        const auto formula = expr::Formula::parse(text, {"x", "y"});
        REQUIRE(formula);
        const double x = 0.37, y = 0.61, h = 1e-6;
        const Two variables[] = {Two::variable(x, 0), Two::variable(y, 1)};
        const Two found = formula_number_of<Two>(*formula, variables);
        const auto value = [&](double a, double b) {
            const double at[] = {a, b};
            return formula->value(at);
        };
        CHECK(found.value == doctest::Approx(value(x, y)).epsilon(1e-13));
        CHECK(found.d[0] == doctest::Approx((value(x + h, y) - value(x - h, y)) / (2 * h)).epsilon(1e-8));
        CHECK(found.d[1] == doctest::Approx((value(x, y + h) - value(x, y - h)) / (2 * h)).epsilon(1e-8));
    }
    CHECK(!has_number(*expr::Formula::parse("noise(x)", {"x"})));
}

}  // namespace
