// A jet: in flat space its flux and its two sides against the closed form of transparent matter that moves, about holes against the reference.
#include <fmt/format.h>

#include <cmath>

#include "plan/medium.h"
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene jet_scene(const char* metric, double spin) {
    Scene scene = bare_scene(metric, spin);
    scene.object.mass_suns = 6.5e9;
    scene.camera.r = 1e5, scene.camera.theta = 1.0, scene.camera.plane_width = 24e-5;
    scene.camera.width = scene.camera.height = 48;
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kJet, medium.inner = 2, medium.outer = 12, medium.edge = 0.5;
    medium.jet = {.opening = 0.3, .falloff = 1.5, .lorentz = 1.6};
    medium.spectral_index = 0.6, medium.emissivity = 1e-22;
    return scene;
}

// f's integral from a to b by Simpson's rule.
template <class F>
double simpson(double a, double b, const F& f) {
    constexpr int kHalves = 400;
    double sum = f(a) + f(b);
    for (int i = 1; i < kHalves; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(a + (b - a) * i / kHalves);
    return sum * (b - a) / kHalves / 3;
}

// Of transparent matter at rest as a whole, far away: intensity over the area that is seen is the volume's integral of j delta^(2 + alpha),
// delta = 1/(gamma (1 - beta cos psi)), psi between motion and line of sight. side: +1 the northern cone, -1 the southern one. In r_s^3.
double flux_of_cone(const Scene& scene, int side) {
    const MediumSpec& m = *scene.medium;
    const double gamma = m.jet.lorentz, beta = std::sqrt(1 - 1 / (gamma * gamma)), view = scene.camera.theta;
    const double along = simpson(std::log(m.inner), std::log(m.outer), [&](double x) {
        const double in = std::min({x - std::log(m.inner), std::log(m.outer) - x, m.edge}) / m.edge;
        return in * in * (3 - 2 * in) * std::exp((3 - m.jet.falloff) * x) * std::pow(m.inner, m.jet.falloff);
    });
    const double across = simpson(0, m.jet.opening, [&](double theta) {
        const double share = 1 - std::pow(std::sin(theta) / std::sin(m.jet.opening), 2);
        return std::sin(theta) * share * share * simpson(0, 2 * M_PI, [&](double phi) {
                   const double cosine =
                       side * std::cos(theta) * std::cos(view) + std::sin(theta) * std::cos(phi) * std::sin(view);
                   return std::pow(gamma * (1 - beta * cosine), -2 - m.spectral_index);
               });
    });
    return flow_numbers(m, *scene.object.mass()).emission * along * across;
}

// The same of a picture's upper half, where the northern cone is, or the lower one.
double flux_of_half(const Image<float>& picture, const Scene& scene, int side) {
    const double pixel = scene.camera.r * scene.camera.plane_width / picture.width;
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if ((y < picture.height / 2) == (side > 0)) sum += picture.at(x, y)[0];
    return sum * pixel * pixel;
}

}  // namespace

TEST_CASE("medium jet: flux of either side in flat space, by volume and Doppler factor") {
    constexpr double kClosed = 2e-3;  // pixels of 0.5 r_s
    on_one_context([&](GpuSession& session) {
        const Scene scene = jet_scene("minkowski", 0);
        const Image<float> gl = picture_of(session, scene), witness = reference_picture(scene);
        for (const int side : {1, -1}) {
            const double known = flux_of_cone(scene, side), shader = flux_of_half(gl, scene, side) / known - 1,
                         reference = flux_of_half(witness, scene, side) / known - 1;
            fmt::print("medium jet, side {}: shader {:+.1e}, reference {:+.1e} of {:.4g}\n", side, shader, reference,
                       known);
            CHECK(std::abs(shader) < kClosed);
            CHECK(std::abs(reference) < kClosed);
        }
        // Of a thin cone both sides differ by ((1 + beta cos i)/(1 - beta cos i))^(2 + alpha).
        Scene thin = scene;
        thin.medium->jet.opening = 0.03, thin.camera.height = 240, thin.camera.width = 240;
        const double beta = std::sqrt(1 - 1 / std::pow(thin.medium->jet.lorentz, 2)), c = beta * std::cos(1.0),
                     known = std::pow((1 + c) / (1 - c), 2 + thin.medium->spectral_index);
        const Image<float> picture = picture_of(session, thin);
        const double found = flux_of_half(picture, thin, 1) / flux_of_half(picture, thin, -1);
        fmt::print("medium jet, of a thin one the sides are {:.3f} to 1, {:.3f}\n", found, known);
        CHECK(std::abs(found / known - 1) < 5e-3);
    });
}

// Almost along the line of sight, where gamma - u.n in floats would be noise.
TEST_CASE("medium jet: the flux of fast ones towards the camera, in flat space") {
    constexpr double kClosed = 5e-3;
    on_one_context([&](GpuSession& session) {
        for (const double lorentz : {30.0, 300.0}) {
            Scene scene = jet_scene("minkowski", 0);
            scene.camera.theta = 1 / lorentz, scene.camera.plane_width = 1.2e-3 / lorentz;
            scene.camera.width = scene.camera.height = 96;  // light comes from within some 1/lorentz
            scene.medium->jet.lorentz = lorentz, scene.medium->jet.opening = 0.05;
            const double known = flux_of_cone(scene, 1) + flux_of_cone(scene, -1);
            const Image<float> picture = picture_of(session, scene);
            const double found = flux_of_half(picture, scene, 1) + flux_of_half(picture, scene, -1);
            fmt::print("medium jet, lorentz {}: {:+.1e} of {:.4g}\n", lorentz, found / known - 1, known);
            CHECK(std::abs(found / known - 1) < kClosed);
        }
    });
}

TEST_CASE("medium jet: about holes, by each emission law, as the reference has it") {
    on_one_context([&](GpuSession& session) {
        for (const auto& [metric, spin] : {std::pair{"schwarzschild", 0.0}, {"kerr", 0.9}})
            for (const MediumEmission law :
                 {MediumEmission::kPowerLaw, MediumEmission::kBlackBody, MediumEmission::kSynchrotron}) {
                Scene scene = jet_scene(metric, spin);
                scene.camera.r = 40, scene.camera.plane_width = 0.6, scene.camera.width = scene.camera.height = 24;
                MediumSpec& medium = *scene.medium;
                medium.emission = law, medium.absorption = 1e6, medium.opacity = 0.5, medium.temperature_K = 6000;
                medium.field_direction = FieldDirection::kEast;
                const bool hot = law == MediumEmission::kSynchrotron;
                medium.density_scale = hot ? 1e4 : 1,
                medium.formulas.temperature = hot ? "6e10/r*(1 + 0.3*x/r)" : "9000/sqrt(r)*(1 + 0.3*x/r)";
                held(session, fmt::format("medium jet, {}, law {}", metric, static_cast<int>(law)), scene,
                     {2e-3, 1e-2});
            }
    });
}
