// Light of electrons of a power law and of a kappa distribution, without polarisation: pictures about holes against the reference's.
#include <fmt/format.h>

#include "support/costly.h"
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// A torus that goes round; thick: of optical depth above 10.
Scene electron_scene(const char* metric, double spin, ElectronKind electrons, bool thick) {
    Scene scene = bare_scene(metric, spin);
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 40, scene.camera.theta = 1.1, scene.camera.plane_width = 0.4;
    scene.camera.width = scene.camera.height = by_depth(16, 32, 48);
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kFormula, medium.emission = MediumEmission::kSynchrotron;
    medium.electrons.kind = electrons;
    medium.formulas.density = fmt::format("{}*exp(-r^2/18-(z/(0.3*max(r,1)))^2/2)", thick ? 3e7 : 1e5);
    medium.formulas.temperature = "3e10*(max(r,1)/2)^(-1)";
    medium.formulas.field = "20*(max(r,1)/2)^(-1.5)";
    medium.formulas.outward = "-0.1", medium.formulas.east = "0.6*(max(r,1)/2)^(-0.5)";
    medium.outer = 10, medium.steps = 160;
    return scene;
}

}  // namespace

TEST_CASE("electrons: pictures of a power law and of kappa, thin and thick") {
    constexpr double kFlux = 1e-3, kPixel = 1e-3, kHalved = 2e-3;  // of the flux, of the brightest pixel
    on_one_context([&](GpuSession& session) {
        for (int i = 0; i < by_depth(2, 8, 8); ++i) {
            const bool kappa = (i & 1) != 0, thick = ((i >> 1) & 1) != (i & 1), isotropic = (i & 4) != 0;
            Scene scene = electron_scene(i % 3 == 0 ? "kerr" : "schwarzschild", i % 3 == 0 ? 0.9 : 0,
                                         kappa ? ElectronKind::kKappa : ElectronKind::kPowerLaw, thick);
            scene.medium->field_direction = isotropic ? FieldDirection::kIsotropic : FieldDirection::kSouth;
            const auto name = fmt::format("electrons, {}{}{}", kappa ? "kappa" : "power law", thick ? ", thick" : "",
                                          isotropic ? ", isotropic" : "");
            held(session, name, scene, {kFlux, kPixel});
            const double whole = sum_of(picture_of(session, scene));
            scene.medium->step = 0.5;
            CHECK(std::abs(sum_of(picture_of(session, scene)) / whole - 1) < kHalved);
        }
    });
}
