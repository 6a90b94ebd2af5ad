// A rotating hole with charge: without charge Kerr's, without rotation Reissner and Nordstrom's, and between them the shader's
// text against the reference, which integrates another formulation.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "observer/spin_forms.h"
#include "reference/kerr_ray.h"
#include "reference/reference.h"
#include "shadercore/core_trace.h"
#include "spacetime/circular_orbit.h"
#include "support/metrics.h"

using namespace nullscope;
using reference::KerrHole;
using reference::KerrRay;

namespace {

constexpr double kKerrNewmanPixel_rad = 6e-4;  // of a 1080p frame of 60 degrees

std::shared_ptr<const AxialMetric> hole(double spin, double charge) {
    return test::axial(*make_spacetime("kerr-newman", {{"spin", spin}, {"charge", charge}}));
}

Vec3 random_direction(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double z = unit(random), turn = M_PI * unit(random), across = std::sqrt(1 - z * z);
    return {z, across * std::cos(turn), across * std::sin(turn)};
}

RayPixel core(const AxialMetric& metric, double r, double theta, Vec3 look, bool in_float) {
    const SpinForms f = spin_forms(spin_place(metric, r, theta), zamo_frame(spin_place(metric, r, theta)));
    const double a = metric.a(), outer = metric.outer_horizon(), inner = metric.inner_horizon();
    CoreInput input;
    FrameData& frame = input.frame;
    frame.image = {1, 1, 1e-6, 1};
    frame.ray_0 = {look, 0};
    frame.shift = {1, 1 / r, 0, 1};
    frame.boost_colour = {1, 0, 0, 0};
    frame.disc_x = {1, 0, 0, 1e30};
    frame.spin_hole = {a, a * a, outer, inner};
    frame.spin_energy = {f.energy.constant, f.energy.radial, f.energy.around, f.p_theta};
    frame.spin_across = {f.across.constant, f.across.radial, f.across.around, f.carter};
    frame.spin_climb = {f.climb.constant, f.climb.radial, f.climb.around, f.carter_slope};
    frame.spin_place = {std::sin(theta), std::cos(theta), 1, 0};
    frame.spin_turn = {metric.azimuth_ahead(r), a / (outer - inner), metric.charge2(), outer - inner};
    input.lensing = false, input.spin = true;
    return in_float ? trace_core32(input, 0, 0) : trace_core64(input, 0, 0);
}

}  // namespace

TEST_CASE("kerr-newman: without charge it is Kerr, number for number") {
    const auto kerr = test::kerr(0.7), charged = hole(0.7, 0);
    for (const double r : {1.2, 3.0, 50.0}) {
        CHECK(charged->metric(r, 1.1) == kerr->metric(r, 1.1));
        CHECK(charged->delta(r) == kerr->delta(r));
        CHECK(circular_orbit(*charged, r + 2)->omega == circular_orbit(*kerr, r + 2)->omega);
    }
    const reference::KerrStart start{6, 1.1, 0, normalized(Vec3{-0.2, 0.5, 0.8})};
    const KerrRay a = reference::trace_kerr(KerrHole(0.7), start, 1),
                  b = reference::trace_kerr(KerrHole(0.7, 0), start, 1);
    CHECK(a.sky == b.sky);
    CHECK(a.delay == b.delay);
}

TEST_CASE("kerr-newman: spin 0 makes Reissner-Nordstrom, and too much of both is refused") {
    CHECK((*make_spacetime("kerr-newman", {{"spin", 0.0}, {"charge", 0.5}}))->name() == "reissner-nordstrom");
    const auto both = make_spacetime("kerr-newman", {{"spin", 0.8}, {"charge", 0.61}});
    REQUIRE_FALSE(both);
    CHECK(both.error().message().find("allowed: spin^2 + charge^2") != std::string::npos);
    CHECK(make_spacetime("kerr-newman", {{"spin", 0.8}, {"charge", 0.59}}));
}

TEST_CASE("kerr-newman: without spin the reference's integrated rays are the closed forms of Reissner-Nordstrom") {
    std::mt19937 random(7);
    double sky = 0, place = 0, delay = 0;
    for (const double charge : {0.3, 0.8, 0.99}) {
        Scene scene;
        scene.spacetime = {"reissner-nordstrom", {{"charge", charge}}};
        for (int i = 0; i < 40; ++i) {
            RayQuery query;
            query.r = i % 2 == 0 ? 3.0 : 20.0, query.theta = 1.1, query.phi = 0.4, query.n = random_direction(random);
            const auto exact = reference::trace_ray(scene, query, 1);
            const KerrRay ray = reference::trace_kerr(
                KerrHole(0, charge), reference::KerrStart{query.r, query.theta, query.phi, query.n}, 1);
            REQUIRE(exact);
            REQUIRE(exact->fate == ray.fate);
            CHECK(std::abs(exact->g * ray.energy - 1) < 1e-13);
            if (ray.fate == Fate::kEscaped) {
                sky = std::max(sky, length(exact->sky - ray.sky));
                delay = std::max(delay, std::abs(exact->delay - ray.delay));
            }
            REQUIRE(exact->crossings.size() == ray.crossings.size());
            if (!ray.crossings.empty())
                place = std::max(place, std::abs(exact->crossings[0].r / ray.crossings[0].r - 1));
        }
    }
    fmt::print("kerr-newman without spin: sky off by {:.1e} rad, T by {:.1e} r_s/c, crossings by {:.1e}\n", sky, delay,
               place);
    CHECK(sky < 1e-10);
    CHECK(delay < 1e-7);
    CHECK(place < 1e-10);
}

TEST_CASE("kerr-newman: the shader core meets the reference, in double and in float") {
    for (const bool in_float : {false, true}) {
        std::mt19937 random(11);
        double worst = 0, worst_g = 0;
        int rays = 0;
        for (const auto& [spin, charge] : {std::pair{0.6, 0.6}, {0.9, 0.4}, {0.3, 0.9}, {0.05, 0.99}}) {
            const auto metric = hole(spin, charge);
            const KerrHole exact_hole(spin, charge);
            for (int i = 0; i < 60; ++i) {
                const double r = 2.0 + 0.5 * i, theta = 0.1 + 0.05 * i;
                const Vec3 look = random_direction(random);
                const auto traced = [&](Vec3 n) {
                    return reference::trace_kerr(exact_hole, reference::KerrStart{r, theta, 0, normalized(n)}, 0);
                };
                const KerrRay exact = traced(look);
                const RayPixel pixel = core(*metric, r, theta, look, in_float);
                CHECK(pixel.fate == exact.fate);
                if (exact.fate != Fate::kEscaped || pixel.fate != exact.fate) continue;
                // How fast the sky moves with the direction: errors are judged in pixels of the view.
                double sway = 1;
                for (const Vec3 by : {Vec3{1e-7, 0, 0}, Vec3{0, 1e-7, 0}, Vec3{0, 0, 1e-7}})
                    sway = std::max(sway, length(traced(look + by).sky - exact.sky) / 1e-7);
                worst = std::max(worst, length(pixel.sky - exact.sky) / sway / kKerrNewmanPixel_rad);
                worst_g = std::max(worst_g, std::abs(pixel.g * exact.energy - 1));
                ++rays;
            }
        }
        fmt::print("kerr-newman, core in {}: {} rays, sky off by {:.4f} px of 1080p, g by {:.1e}\n",
                   in_float ? "float" : "double", rays, worst, worst_g);
        CHECK(rays > 150);
        CHECK(worst < 0.05);
        CHECK(worst_g < (in_float ? 2e-6 : 1e-12));
    }
}

TEST_CASE("kerr-newman: the innermost stable orbit without spin, and where E has its least value with it") {
    for (const double charge : {0.3, 0.8}) {  // r^3 - 6 M r^2 + 9 Q^2 r - 4 Q^4/M = 0
        const auto s = *make_spacetime("reissner-nordstrom", {{"charge", charge}});
        const double r = 2 * *innermost_stable_orbit(*s), q2 = charge * charge;
        CHECK(std::abs(r * r * r - 6 * r * r + 9 * q2 * r - 4 * q2 * q2) < 1e-11);
    }
    for (const auto& [spin, charge] : {std::pair{0.6, 0.6}, {0.9, 0.4}}) {
        const auto s = hole(spin, charge);
        const double r = *innermost_stable_orbit(*s), energy = circular_orbit(*s, r)->energy;
        for (const double by : {0.99, 0.999, 1.001, 1.01}) CHECK(circular_orbit(*s, by * r)->energy > energy);
        CHECK(light_orbit(*s) < r);
        CHECK(light_orbit(*s) > s->outer_horizon());
        const MatterVelocity u = disc_matter(*s, 0.5 * (r + s->outer_horizon()));
        const Matrix4 g = s->metric(0.5 * (r + s->outer_horizon()), M_PI / 2);
        CHECK(g[0][0] * u.u_t * u.u_t + 2 * g[0][3] * u.u_t * u.u_phi + g[3][3] * u.u_phi * u.u_phi +
                  g[1][1] * u.u_r * u.u_r ==
              doctest::Approx(-1).epsilon(1e-10));
    }
}
