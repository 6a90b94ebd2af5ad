// Stokes parameters of matter along rays as the GPU draws them, against the reference: axes that are carried along the rays by integration, the
// exponential of the transfer matrix, coefficients in cgs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/assets.h"
#include "reference/matter_stokes.h"
#include "scene/projection.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kStokesError = 5e-3;  // of the brightest pixel, as intensities of matter (docs/matter.md)
constexpr double kStokesFlux = 1e-3;   // of the flux, likewise

// Synchrotron light of a torus that goes round, with a field in one direction of the matter's frame. cold: dense matter of M87's size, in which
// Faraday rotation turns light by some 30 rad.
Scene polarised_matter(const SpacetimeSpec& spacetime, FieldDirection field, bool cold) {
    Scene scene;
    scene.spacetime = spacetime;
    scene.picture.refine = false;
    scene.sky.kind = SkyKind::kBlack;
    scene.object.mass_suns = 4.3e6;
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kFormula;
    medium.emission = MediumEmission::kSynchrotron;
    medium.formulas.density = "2e5*exp(-r^2/18-(z/(0.3*max(r,1)))^2/2)";
    medium.formulas.temperature = "4e10*(max(r,1)/2)^(-1)";
    medium.formulas.field = "20*(max(r,1)/2)^(-1.5)";
    if (cold) {
        scene.object.mass_suns = 6.2e9;
        medium.formulas.density = "3e3*exp(-r^2/18-(z/(0.3*max(r,1)))^2/2)",
        medium.formulas.temperature = "8e9*(max(r,1)/2)^(-1)";
        medium.frequency_GHz = 86, medium.step = 0.25;
    }
    medium.formulas.outward = "-0.1", medium.formulas.south = "0.05", medium.formulas.east = "0.6*(max(r,1)/2)^(-0.5)";
    medium.field_direction = field;
    medium.polarisation = true;
    medium.outer = 10, medium.steps = 160;
    return scene;
}

struct WorstStokes {
    std::array<double, 4> error{}, sum{}, exact{};
};

void compare_stokes(GpuSession& session, const Scene& scene, WorstStokes& worst) {
    const auto exact = reference::MatterStokes::make(scene);
    REQUIRE(exact);
    const auto from = exact->axes_of(scene.camera);
    REQUIRE(from);
    REQUIRE(session.renderer->prepare(scene));
    const Image<float> stokes = draw_layers(*session.renderer).stokes;
    REQUIRE(!stokes.empty());
    const double most = *std::ranges::max_element(stokes.data);
    REQUIRE(most > 0);
    for (int y = 1; y < scene.camera.height; y += by_depth(6, 3, 3))
        for (int x = 1; x < scene.camera.width; x += by_depth(5, 3, 3)) {
            const auto told = exact->at(*from, normalized(pixel_direction(scene.camera, x + 0.5, y + 0.5)));
            for (std::size_t c = 0; c < 4; ++c) {
                worst.error[c] = std::max(worst.error[c], std::abs(stokes.at(x, y)[c] - told.light[c]) / most);
                worst.sum[c] += stokes.at(x, y)[c], worst.exact[c] += told.light[c];
            }
        }
}

void hold(const std::string& name, const WorstStokes& worst) {
    fmt::print("{}: I, Q, U, V within {:.2g} of the brightest; sums {:.6g}, exact {:.6g}\n", name,
               fmt::join(worst.error, " "), fmt::join(worst.sum, " "), fmt::join(worst.exact, " "));
    for (std::size_t c = 0; c < 4; ++c) {
        CHECK(worst.error[c] < kStokesError);
        CHECK(std::abs(worst.sum[c] - worst.exact[c]) < kStokesFlux * worst.exact[0]);
    }
}

}  // namespace

TEST_CASE("polarised matter: I, Q, U and V are the reference's") {
    const SpacetimeSpec metrics[] = {{"kerr", {{"spin", 0.9}}},
                                     {"schwarzschild", {}},
                                     {"kerr-newman", {{"spin", 0.6}, {"charge", 0.7}}},
                                     {"minkowski", {}}};
    on_one_context([&](GpuSession& session) {
        for (int i = 0; i < by_depth(3, 12, 12); ++i) {
            const auto field = static_cast<FieldDirection>(1 + i % 3);
            Scene scene = polarised_matter(metrics[i % 4], field, i % 3 == 2);
            if (i == 1)
                scene.medium->field_direction = FieldDirection::kVector, scene.medium->field_vector = {0.8, -0.4, 0.3};
            CameraSpec& camera = scene.camera;
            camera.width = 40, camera.height = 24;
            camera.r = i % 2 == 0 ? 60 : 15, camera.theta = 0.4 + 0.8 * (i % 3), camera.phi = 0.7, camera.roll = 0.4;
            camera.plane_width = 16.0 / camera.r, camera.focal_distance = 1;
            WorstStokes worst;
            compare_stokes(session, scene, worst);
            hold(fmt::format("{} field {}", scene.spacetime.metric, i % 3), worst);
        }
    });
}

TEST_CASE("polarised matter: of a file, with the field that it has" * test::costly()) {
    on_one_context([&](GpuSession& session) {
        Scene scene = polarised_matter({"kerr", {{"spin", 0.9}}}, FieldDirection::kFile, false);
        MediumSpec& medium = *scene.medium;
        medium.kind = MediumKind::kGrid, medium.grid.file = assets_directory() / "medium" / "torus.grid";
        medium.outer = 12, medium.steps = 64, scene.object.mass_suns = 6.2e9;
        CameraSpec& camera = scene.camera;
        camera.width = 40, camera.height = 24, camera.r = 500, camera.theta = 0.96;
        camera.plane_width = 18.0 / camera.r, camera.focal_distance = 1;
        WorstStokes worst;
        compare_stokes(session, scene, worst);
        hold("torus of a file", worst);
    });
}

// Thin; and so thick that of the least absorbed of its two modes a part is seen far behind what hides the other one.
TEST_CASE("polarised matter: electrons of a power law and of kappa") {
    constexpr double kPixel = 1e-3, kHalved = 2e-3;  // of the brightest pixel; of the flux, where the step is halved
    on_one_context([&](GpuSession& session) {
        for (int i = 0; i < by_depth(2, 4, 4); ++i) {
            const bool kappa = i % 2 == 1, dense = i < 2;
            Scene scene = polarised_matter({"kerr", {{"spin", 0.9}}}, FieldDirection::kVector, false);
            MediumSpec& medium = *scene.medium;
            medium.field_vector = {0.8, -0.4, 0.3};
            medium.electrons.kind = kappa ? ElectronKind::kKappa : ElectronKind::kPowerLaw;
            medium.electrons.gamma_min = dense ? 5 : 30;
            medium.formulas.density =
                fmt::format("{}*exp(-r^2/18-(z/(0.3*max(r,1)))^2/2)", dense ? (kappa ? 1e8 : 3e7) : 1e5);
            CameraSpec& camera = scene.camera;
            camera.width = 40, camera.height = 24, camera.r = 60, camera.theta = 1.0, camera.roll = 0.4;
            camera.plane_width = 16.0 / camera.r, camera.focal_distance = 1;
            WorstStokes worst;
            compare_stokes(session, scene, worst);
            hold(fmt::format("electrons, {}{}", kappa ? "kappa" : "power law", dense ? ", dense" : ""), worst);
            for (const double error : worst.error) CHECK(error < kPixel);
            const auto flux = [&] {
                REQUIRE(session.renderer->prepare(scene));
                const Image<float> stokes = draw_layers(*session.renderer).stokes;
                std::array<double, 4> sum{};
                for (std::size_t n = 0; n < stokes.data.size(); ++n) sum[n % 4] += stokes.data[n];
                return sum;
            };
            const auto whole = flux();
            medium.step = 0.5;
            const auto halved = flux();
            for (std::size_t c = 0; c < 4; ++c) CHECK(std::abs(halved[c] - whole[c]) < kHalved * whole[0]);
        }
    });
}

// Samples beyond the matter have no direction; they are none of the picture's.
TEST_CASE("polarised matter: a flow's Q, U and V are numbers everywhere") {
    on_one_context([](GpuSession& session) {
        Scene scene = polarised_matter({"kerr", {{"spin", 0.9}}}, FieldDirection::kEast, false);
        MediumSpec& medium = *scene.medium;
        scene.object.mass_suns = 6.5e9;
        medium.kind = MediumKind::kFlow, medium.density_scale = 1e5;
        medium.formulas.temperature = "5e10", medium.formulas.field = "10";
        CameraSpec& camera = scene.camera;
        camera.width = 16, camera.height = 10, camera.r = 60, camera.theta = 1.05;
        camera.plane_width = 12.6 / camera.r, camera.focal_distance = 1;
        for (const ElectronKind kind : {ElectronKind::kThermal, ElectronKind::kPowerLaw, ElectronKind::kKappa}) {
            medium.electrons.kind = kind;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> stokes = draw_layers(*session.renderer).stokes;
            CHECK(std::ranges::all_of(stokes.data, [](float part) { return std::isfinite(part); }));
            CHECK(*std::ranges::max_element(stokes.data) > 0);
            if (kind != ElectronKind::kPowerLaw) continue;
            // Where it is opaque: what is left of the mode that is absorbed least counts.
            const auto exact = reference::MatterStokes::make(scene);
            REQUIRE(exact);
            const auto from = exact->axes_of(camera);
            REQUIRE(from);
            for (const int x : {4, 6}) {
                const auto told = exact->at(*from, normalized(pixel_direction(camera, x + 0.5, 5.5)));
                CHECK(std::abs(stokes.at(x, 5)[0] / told.light[0] - 1) < kStokesError);
            }
        }
    });
}

// Where neither absorption nor conversion acts on what is polarised.
TEST_CASE("polarised matter: the intensity of thin matter is what it is without polarisation") {
    constexpr double kIntensity = 1e-5;  // of the brightest pixel
    on_one_context([&](GpuSession& session) {
        for (const bool faraday : {false, true}) {
            Scene scene = polarised_matter({"kerr", {{"spin", 0.9}}}, FieldDirection::kSouth, false);
            scene.medium->formulas.density = "exp(-r^2/18-(z/(0.3*max(r,1)))^2/2)";
            scene.medium->brightness = 1e6, scene.medium->faraday = faraday;
            CameraSpec& camera = scene.camera;
            camera.width = 40, camera.height = 24, camera.r = 60, camera.theta = 1.1;
            camera.plane_width = 16.0 / camera.r, camera.focal_distance = 1;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> with = session.renderer->picture();
            scene.medium->polarisation = false;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> without = session.renderer->picture();
            const double most = *std::ranges::max_element(without.data);
            REQUIRE(most > 0);
            double worst = 0;
            for (std::size_t i = 0; i < with.data.size(); ++i)
                worst = std::max(worst, std::abs(static_cast<double>(with.data[i]) - without.data[i]) / most);
            fmt::print("intensity with polarisation: within {:.2g} of the brightest\n", worst);
            CHECK(worst < kIntensity);
        }
    });
}
