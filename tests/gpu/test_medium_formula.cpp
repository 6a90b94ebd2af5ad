// Matter by formula: closed forms of radiative transfer, and pictures about holes against the reference's.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "light/black_body.h"
#include "plan/medium.h"
#include "reference/emission.h"
#include "reference/seen_light.h"
#include "scene/known_object.h"
#include "support/costly.h"
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kClosed = 1e-4;  // of the brightest, and of the flux: what is promised

Scene formula_scene(const char* metric, double spin, MediumEmission emission) {
    Scene scene = bare_scene(metric, spin);
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 10, scene.camera.theta = 1.2, scene.camera.plane_width = 0.21;
    scene.camera.width = scene.camera.height = by_depth(25, 65, 65);
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kFormula, medium.emission = emission;
    medium.formulas.density = "1", medium.outer = 1;
    return scene;
}

double length_cm(const Scene& scene) { return 100 * schwarzschild_radius_m(*scene.object.mass_suns); }

// Where the line of sight of a pixel's middle passes the centre, over the sphere's radius.
double impact(const Scene& scene, int x, int y) {
    const double side = scene.camera.plane_width / scene.camera.width, u = side * (x + 0.5 - 0.5 * scene.camera.width),
                 v = side * (y + 0.5 - 0.5 * scene.camera.height);
    return scene.camera.r * std::hypot(u, v) / std::hypot(u, v, 1);
}

// light(impact): the closed form. Largest difference over the brightest, and that of the flux.
template <class Light>
std::array<double, 2> off(const Image<float>& picture, const Scene& scene, const Light& light) {
    double worst = 0, brightest = 0, flux = 0, known = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double expected = light(impact(scene, x, y)), one = picture.at(x, y)[0];
            worst = std::isfinite(one) ? std::max(worst, std::abs(one - expected)) : INFINITY;
            brightest = std::max(brightest, expected);
            flux += one, known += expected;
        }
    return {worst / brightest, flux / known - 1};
}

template <class Light>
void check_closed(GpuSession& session, const char* name, const Scene& scene, const Light& light) {
    CAPTURE(name);
    const auto [gl, gl_flux] = off(picture_of(session, scene), scene, light);
    const auto [witness, witness_flux] = off(reference_picture(scene), scene, light);
    CHECK(gl < kClosed);
    CHECK(std::abs(gl_flux) < kClosed);
    CHECK(witness < kClosed);
    CHECK(std::abs(witness_flux) < kClosed);
    fmt::print("medium, {}: gl {:.1e}, flux {:+.1e}; reference {:.1e}, flux {:+.1e}\n", name, gl, gl_flux, witness,
               witness_flux);
}

}  // namespace

TEST_CASE("medium: closed forms of a thin sphere, a thick one and a slab" * test::costly()) {
    on_every_context([&](GpuSession& session) {
        Scene thin = formula_scene("minkowski", 0, MediumEmission::kPowerLaw);
        thin.medium->emissivity = 1e-16;
        thin.medium->formulas.density = "0.25", thin.medium->density_scale = 4;
        const double each = 1e-16 * length_cm(thin) / medium_light_cgs(230);
        check_closed(session, "thin sphere", thin,
                     [&](double b) { return b < 1 ? each * 2 * std::sqrt(1 - b * b) : 0.0; });

        Scene thick = formula_scene("minkowski", 0, MediumEmission::kSynchrotron);
        thick.medium->formulas.density = "1e14", thick.medium->formulas.temperature = "3e9";
        thick.medium->formulas.field = "1000";
        const double black = reference::planck(3e9, 230e9) / medium_light_cgs(230);
        check_closed(session, "thick sphere, synchrotron", thick, [&](double b) { return b < 1 ? black : 0.0; });

        // Of bremsstrahlung by alpha^3 hbar^3/m in place of e^6/(m c^3), thin and thick.
        Scene ions = formula_scene("minkowski", 0, MediumEmission::kBremsstrahlung);
        ions.medium->formulas.density = "1e4", ions.medium->formulas.temperature = "1e6",
        ions.medium->frequency_GHz = 10;
        constexpr double kFine = 7.2973525693e-3, kReduced = 1.054571817e-27, kMass = 9.1093837e-28,
                         kHeat = 1.380649e-16;
        const double gaunt = std::sqrt(3.0) / M_PI * (17.7 + std::log(1e9 / 10e9)),
                     ion = 8.0 / 3 * std::pow(kFine * kReduced, 3) / kMass * std::sqrt(2 * M_PI / (3 * kHeat * kMass)) *
                           1e8 / 1e3 * gaunt * std::exp(-kReduced * 2 * M_PI * 10e9 / (kHeat * 1e6)),
                     thin_ions = ion * length_cm(ions) / medium_light_cgs(10);
        check_closed(session, "thin sphere, bremsstrahlung", ions,
                     [&](double b) { return b < 1 ? thin_ions * 2 * std::sqrt(1 - b * b) : 0.0; });
        ions.medium->formulas.density = "1e14";
        const double hot = reference::planck(1e6, 10e9) / medium_light_cgs(10);
        check_closed(session, "thick sphere, bremsstrahlung", ions, [&](double b) { return b < 1 ? hot : 0.0; });
        // Beyond Rayleigh and Jeans' law, by exp(-4.8).
        ions.medium->formulas.density = "1e20", ions.medium->frequency_GHz = 1e8;
        const double wien = reference::planck(1e6, 1e17) / medium_light_cgs(1e8);
        check_closed(session, "thick sphere, X-rays", ions, [&](double b) { return b < 1 ? wien : 0.0; });

        Scene warm = formula_scene("minkowski", 0, MediumEmission::kBlackBody);
        warm.medium->formulas.temperature = "5000", warm.medium->temperature_K = 6000, warm.medium->opacity = 1e6;
        const double red = reference::seen_black_body(5000, 1, warm.light).x / std::exp2(log2_brightness(6000, false));
        check_closed(session, "thick sphere, black body", warm, [&](double b) { return b < 1 ? red : 0.0; });

        // A slab that fills the picture, seen from above.
        Scene slab = formula_scene("minkowski", 0, MediumEmission::kPowerLaw);
        slab.camera.theta = 0, slab.camera.plane_width = 0.8;
        slab.medium->outer = 9, slab.medium->height = 0.5, slab.medium->steps = 256;
        slab.medium->emissivity = 1e-16, slab.medium->absorption = 6e3;
        const double depth = 6e3 * 1e-16 * length_cm(slab), source = each / depth;
        check_closed(session, "slab", slab, [&](double b) {
            const double cosine = std::sqrt(1 - b * b / (slab.camera.r * slab.camera.r));
            return source * -std::expm1(-depth / cosine);
        });
    });
}

TEST_CASE("medium: what one electron emits and how many there are may both have no room in a float" * test::costly()) {
    constexpr double kFlux = 1e-3;
    struct Case {
        const char *density, *temperature, *field;
        double frequency_GHz;
    };
    const Case cases[] = {{"1e15", "1e9", "1000", 86},   {"1e16", "1e9", "1000", 86}, {"1e20", "6e8", "10", 20},
                          {"1e24", "6e8", "10", 30},     {"1e29", "6e8", "10", 50},   {"1e29", "3e9", "1000", 230},
                          {"1e-20", "1e12", "1e6", 1e3}, {"1e10", "1e10", "1e8", 1e9}};
    on_every_context([&](GpuSession& session) {
        for (const Case& c : cases) {
            Scene scene = formula_scene("minkowski", 0, MediumEmission::kSynchrotron);
            scene.camera.width = scene.camera.height = 15;
            scene.medium->formulas = {.density = c.density, .temperature = c.temperature, .field = c.field};
            scene.medium->frequency_GHz = c.frequency_GHz;
            CHECK(sum_of(reference_picture(scene)) > 0);
            held(session,
                 fmt::format("medium, {} electrons a cm^3 of {} K in {} G at {} GHz", c.density, c.temperature, c.field,
                             c.frequency_GHz),
                 scene, {kFlux});
        }
        // A power law likewise, thin and opaque.
        for (const double absorption : {0.0, 1e30}) {
            Scene scene = formula_scene("minkowski", 0, MediumEmission::kPowerLaw);
            scene.camera.width = scene.camera.height = 15;
            scene.medium->formulas.density = "1e28";
            scene.medium->emissivity = absorption > 0 ? 1e-20 : 1e-46, scene.medium->absorption = absorption;
            CHECK(sum_of(reference_picture(scene)) > 0);
            held(session, fmt::format("medium, power law, absorption {}", absorption), scene, {kFlux});
        }
    });
}

// Of cameras so far away that a step of the march is below the rounding of their distance.
TEST_CASE("medium: from far away a thin sphere is its closed form, and holes dim it as from nearby" * test::costly()) {
    constexpr double kFlux = 5e-4;
    on_every_context([&](GpuSession& session) {
        for (const double r : {120.0, 150.0, 1e3, 1e5, 1e7, 1e9}) {
            Scene thin = formula_scene("minkowski", 0, MediumEmission::kPowerLaw);
            thin.camera.r = r, thin.camera.plane_width = 2.1 / r;
            thin.medium->emissivity = 1e-16, thin.medium->steps = 256;
            const double each = 1e-16 * length_cm(thin) / medium_light_cgs(230);
            const auto [worst, flux] = off(picture_of(session, thin), thin,
                                           [&](double b) { return b < 1 ? each * 2 * std::sqrt(1 - b * b) : 0.0; });
            fmt::print("medium, thin sphere from {}: {:.1e}, flux {:+.1e}\n", r, worst, flux);
            CAPTURE(r);
            CHECK(worst < kClosed);
            CHECK(std::abs(flux) < kClosed);
        }
        for (const char* metric : {"schwarzschild", "reissner-nordstrom", "kerr"}) {
            double near = 0;
            for (const double r : {1e4, 1e6, 1e8, 1e9}) {
                CAPTURE(metric);
                CAPTURE(r);
                Scene scene = formula_scene(metric, 0, MediumEmission::kPowerLaw);
                if (metric == std::string("kerr")) scene.spacetime.parameters["spin"] = 1e-6;
                if (metric == std::string("reissner-nordstrom")) scene.spacetime.parameters["charge"] = 0.5;
                scene.camera.r = r, scene.camera.plane_width = 12.0 / r;
                scene.camera.width = scene.camera.height = 24;
                scene.medium->formulas.density = "exp(-r^2/2)", scene.medium->outer = 5;
                const double flux = sum_of(picture_of(session, scene));
                near = near > 0 ? near : flux;
                fmt::print("medium, {} from {}: {:+.1e}\n", metric, r, flux / near - 1);
                CHECK(std::abs(flux / near - 1) < kFlux);
            }
        }
    });
}

TEST_CASE("medium: matter by formula about holes is the reference's" * test::costly()) {
    constexpr double kFlux = 1e-3, kPixel = 5e-3;
    struct Case {
        const char *name, *metric;
        double spin;
        MediumEmission emission;
        FieldDirection direction;
        MediumFormulas formulas;
        int steps = 128;
    };
    // Infall, circular orbits and a spiral; a clump that moves with time; cones of temperature.
    using enum MediumEmission;
    using enum FieldDirection;
    const MediumFormulas infall{.density = "exp(-r^2/8)", .outward = "-1/sqrt(max(r - 1, 0.01))"},
        circles{.density = "2e6*exp(-(r/4)^2 - (3*z/r)^2)",
                .temperature = "6e10/r",
                .field = "60/r",
                .east = "sqrt(0.5/max(r - 1.5, 0.5))"},
        spiral{.density = "3e7*exp(-(r/4)^2)*(1.2 + sin(2*atan(y, x) + 3*log(r)))",
               .temperature = "8e10/r",
               .field = "100/r",
               .outward = "-0.4/r",
               .south = "0.2*z/r",
               .east = "0.5/sqrt(r)"},
        thick{.density = "1e8*exp(-(r/3)^2)", .temperature = "5e10/r", .field = "100/r", .outward = "-0.3"},
        clump{.density = "exp(-((x - 4*cos(0.1*t))^2 + (y - 4*sin(0.1*t))^2 + z^2)/2)",
              .temperature = "5000 + 1000*z/r",
              .east = "0.4"};
    const Case cases[] = {
        {"infall", "schwarzschild", 0, kPowerLaw, kIsotropic, infall},
        {"circles, synchrotron", "schwarzschild", 0, kSynchrotron, kSouth, circles},
        {"spiral, synchrotron", "kerr", 0.9, kSynchrotron, kEast, spiral, 192},  // its arms wind up towards the horizon
        {"isotropic, thick", "kerr", 0.7, kSynchrotron, kIsotropic, thick},
        {"moving clump, black body", "schwarzschild", 0, kBlackBody, kIsotropic, clump, 192}};
    on_every_context([&](GpuSession& session) {
        Selection selection(2);  // each emission once
        for (const Case& one : cases) {
            if (!selection.takes_next()) continue;
            Scene scene = formula_scene(one.metric, one.spin, one.emission);
            scene.camera.r = 30, scene.camera.plane_width = 0.45, scene.time = 40;
            scene.camera.width = scene.camera.height = by_depth(20, 32, 64);
            scene.medium->formulas = one.formulas, scene.medium->field_direction = one.direction;
            scene.medium->outer = 8, scene.medium->steps = one.steps;
            scene.medium->emissivity = 1e-18, scene.medium->temperature_K = 6000, scene.medium->density_scale = 1.5;
            const Difference off = held(session, fmt::format("medium, {}", one.name), scene, {kFlux, kPixel});
            const double known = sum_of(reference_picture(scene));
            scene.medium->step = 0.5;
            CHECK(std::abs((1 + off.flux) * known / sum_of(picture_of(session, scene)) - 1) < kFlux);
        }
    });
}

TEST_CASE("medium: pixels with more rays about a rotating hole end within what a software driver runs" *
          test::costly()) {
    // llvmpipe ends a shader after 65535 rounds of all its loops: rays next to the critical one were cut off, and dark.
    constexpr double kLeast = 0.25;  // of the light of one ray, which on a ring thinner than a pixel is twice the mean
    on_every_context([&](GpuSession& session) {
        Scene scene = formula_scene("kerr", 0.9, MediumEmission::kSynchrotron);
        scene.camera.r = 500, scene.camera.theta = 0.3, scene.camera.plane_width = 0.02;
        scene.camera.width = scene.camera.height = 96;
        scene.medium->formulas = {
            .density = "4e5*r^-1.5", .temperature = "9e10*r^-0.8", .field = "20/r", .outward = "-0.3/r"};
        scene.medium->outer = 12, scene.medium->steps = 128;
        const Image<float> one = picture_of(session, scene);
        scene.picture.refine = true;
        const Image<float> several = picture_of(session, scene);
        double least = 1;
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x)
                if (one.at(x, y)[0] > 1e-3) least = std::min<double>(least, several.at(x, y)[0] / one.at(x, y)[0]);
        CHECK(least > kLeast);
        fmt::print("medium, pixels with more rays: at least {:.3f} of one ray's light\n", least);
    });
}

TEST_CASE("medium: what shines through thick matter, however bright it is") {
    constexpr double kSame = 0.01;
    on_every_context([&](GpuSession& session) {
        Scene scene = formula_scene("minkowski", 0, MediumEmission::kBlackBody);
        scene.camera.width = scene.camera.height = 5, scene.camera.plane_width = 0.01;  // within the ball
        scene.medium->formulas.temperature = "700", scene.medium->outer = 2;
        scene.bodies.push_back({SphereSpec{1}});
        scene.bodies.back().material.colour = {1, 1, 1}, scene.bodies.back().material.brightness = 1e6;
        scene.medium->opacity = 11;
        CHECK(std::abs(picture_of(session, scene).at(2, 2)[0] / (1e6 * std::exp(-11.0)) - 1) < kSame);
        scene.medium->opacity = 50;
        CHECK(picture_of(session, scene).at(2, 2)[0] < 1e-6);
    });
}

TEST_CASE("disc: a bright sky behind one that hides nearly all") {
    on_every_context([&](GpuSession& session) {
        Scene scene = bare_scene("schwarzschild", 0);
        scene.camera.r = 30, scene.camera.theta = 0.5, scene.camera.width = scene.camera.height = 4;
        scene.camera.yaw = 0.26, scene.camera.plane_width = 0.02;
        scene.sky.material.colour = {1, 1, 1}, scene.sky.brightness = 1000;
        DiscSpec& disc = scene.disc.emplace();
        disc.material.texture = TextureKind::kPlain, disc.opacity = 0.999, disc.brightness = 1e-3;
        CHECK(std::abs(sum_of(picture_of(session, scene)) / sum_of(reference_picture(scene)) - 1) < 0.01);
    });
}

TEST_CASE("medium: the shortest steps reach the end of the matter") {
    constexpr double kSame = 2e-3;
    on_every_context([&](GpuSession& session) {
        Scene ball = formula_scene("minkowski", 0, MediumEmission::kPowerLaw);
        ball.camera.r = 30, ball.camera.width = ball.camera.height = 8;
        ball.medium->outer = 8, ball.medium->steps = 1024;
        Scene flow = ball;
        flow.spacetime.metric = "schwarzschild", flow.camera.theta = M_PI / 2;
        flow.camera.height = 7;  // a row in the plane
        flow.medium->kind = MediumKind::kFlow, flow.medium->flow.flattening = 100;
        for (Scene* scene : {&ball, &flow}) {
            const double usual = sum_of(picture_of(session, *scene));
            scene->medium->step = 0.05;
            CHECK(std::abs(sum_of(picture_of(session, *scene)) / usual - 1) < kSame);
        }
    });
}
