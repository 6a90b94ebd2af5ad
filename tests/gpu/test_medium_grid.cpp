// Matter of a file: pictures about holes against the reference's, and against matter by the formulas that the file was made of.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/atomic_file.h"
#include "support/costly.h"
#include "support/medium_files.h"
#include "support/medium_pictures.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene grid_scene(const TemporaryFolder& folder, const char* metric, const GridForm& form,
                 const std::function<GridNode(double, double, double)>& node) {
    Scene scene = bare_scene(metric, form.spin);
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 30, scene.camera.theta = 1.2, scene.camera.plane_width = 0.45;
    scene.camera.width = scene.camera.height = by_depth(20, 32, 64);
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kGrid, medium.outer = 8, medium.steps = 128;
    medium.grid.file = folder.path / fmt::format("{}-{}.grid", metric, form.coordinates);
    REQUIRE(write_text_atomically(medium.grid.file, grid_bytes(form, node)));
    return scene;
}

GridForm form_of(const char* coordinates, double spin) {
    GridForm form;
    form.coordinates = coordinates, form.spin = spin;
    form.nearest = 1.02 * (0.5 + std::sqrt(0.25 - 0.25 * spin * spin)), form.farthest = 8.5;
    form.rings = 40, form.polar = 25, form.around = 32;
    return form;
}

}  // namespace

TEST_CASE("medium grid: matter of a file about holes is the reference's" * test::costly()) {
    constexpr double kFlux = 1e-3, kPixel = 5e-3;
    // Two arms that fall in, in a field that is wound up; and a spot in flat space's coordinates, warm at one side.
    const auto arms = [](double r, double theta, double phi) {
        const double up = std::cos(theta) / 0.4;
        return GridNode{3e7 * std::exp(-0.06 * r * r - 0.5 * up * up) * (1.2 + std::sin(2 * phi + 3 * std::log(r))),
                        8e10 / r,
                        20 / r,
                        10 / r,
                        100 / r,
                        -0.4 / r,
                        0.2 * std::cos(theta),
                        0.5 / std::sqrt(r)};
    };
    const auto spot = [](double r, double theta, double phi) {
        const double x = r * std::sin(theta) * std::cos(phi), y = r * std::sin(theta) * std::sin(phi),
                     z = r * std::cos(theta);
        return GridNode{std::exp(-0.3 * ((x - 3) * (x - 3) + y * y + z * z)), 6000 + 500 * z / r, 0, 0, 0, 0, 0, 0.4};
    };
    on_every_context([&](GpuSession& session) {
        const TemporaryFolder folder("grid");
        Scene synchrotron = grid_scene(folder, "kerr", form_of("kerr-schild", 0.9), arms);
        synchrotron.medium->emission = MediumEmission::kSynchrotron;
        synchrotron.medium->field_direction = FieldDirection::kFile;
        synchrotron.medium->density_scale = 0.7, synchrotron.medium->steps = 192;
        Scene isotropic = grid_scene(folder, "kerr", form_of("boyer-lindquist", 0.5), arms);
        isotropic.medium->emission = MediumEmission::kSynchrotron, isotropic.medium->steps = 192;
        Scene power = grid_scene(folder, "schwarzschild", form_of("kerr-schild", 0), spot);
        power.medium->emissivity = 1e-18;
        Scene warm = grid_scene(folder, "schwarzschild", form_of("boyer-lindquist", 0), spot);
        warm.medium->emission = MediumEmission::kBlackBody, warm.medium->temperature_K = 6000;
        Selection selection(2);
        for (const auto& [name, scene] : {std::pair{"arms, the file's field", &synchrotron},
                                          {"arms, isotropic field", &isotropic},
                                          {"spot, power law", &power},
                                          {"spot, black body", &warm}}) {
            if (selection.takes_next()) held(session, fmt::format("medium grid, {}", name), *scene, {kFlux, kPixel});
        }
    });
}

TEST_CASE("medium grid: a fine grid of formulas is matter by these formulas" * test::costly()) {
    constexpr double kFlux = 1e-3, kPixel = 5e-3;  // trilinear between nodes: falls as the square of their distance
    GridForm form = form_of("boyer-lindquist", 0.9);
    form.rings = 120, form.polar = 61, form.around = 64;
    on_every_context([&](GpuSession& session) {
        const TemporaryFolder folder("grid");
        Scene scene = grid_scene(folder, "kerr", form, [](double r, double theta, double phi) {
            const double x = r * std::sin(theta) * std::cos(phi), y = r * std::sin(theta) * std::sin(phi),
                         z = r * std::cos(theta);
            return GridNode{2e6 * std::exp(-0.1 * ((x - 2) * (x - 2) + y * y) - z * z / 3),
                            6e10 / r,
                            0,
                            0,
                            60 / r,
                            -0.3 / r,
                            0,
                            0.5 / std::sqrt(r)};
        });
        scene.medium->emission = MediumEmission::kSynchrotron;
        scene.medium->field_direction = FieldDirection::kFile;
        const Image<float> of_file = picture_of(session, scene);
        scene.medium->kind = MediumKind::kFormula;
        scene.medium->field_direction = FieldDirection::kEast;
        scene.medium->formulas = {.density = "2e6*exp(-0.1*((x - 2)^2 + y^2) - z^2/3)",
                                  .temperature = "6e10/r",
                                  .field = "60/r",
                                  .outward = "-0.3/r",
                                  .east = "0.5/sqrt(r)"};
        const Difference off = difference(of_file, picture_of(session, scene), kPixel);
        CHECK(std::abs(off.flux) < kFlux);
        CHECK(off.largest < kPixel);
        fmt::print("medium grid, of formulas: flux {:+.1e}, pixels {:.1e}\n", off.flux, off.largest);
    });
}
