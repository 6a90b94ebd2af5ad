// What the reference integrates about a rotating hole: the equations against those in Kerr and Schild's coordinates, the
// step, the lanes, and rays far away against closed forms.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "reference/frame_tracer.h"
#include "reference/kerr_chart.h"
#include "reference/kerr_flow.h"
#include "reference/kerr_lanes.h"
#include "reference/kerr_ray.h"
#include "reference/kerr_step.h"
#include "reference/reference.h"
#include "scene/bodies.h"

namespace {

using namespace nullscope;
using namespace nullscope::reference;

// A photon with its energy at a place, as kerr_chart.h and as kerr_flow.h have it.
struct Light {
    double energy;
    Vec3 x, p;
    FlowState<double> state;
    FlowRay<double> ray;
};
Light light_at(const KerrHole& hole, Vec3 x, Vec3 p) {
    const KerrChart chart{hole};
    const KerrChart::Pull pull = chart.pull(1, x, p);
    const double twice_h = pull.delay / pull.lp, climb = pull.lp - 1;  // p^2 = energy^2 + 2 H (energy + l p)^2
    const double energy =
        (std::sqrt((1 + twice_h) * dot(p, p) - twice_h * climb * climb) - twice_h * climb) / (1 + twice_h);
    const Vec3 n = normalized(x), momentum = cross(x, p);
    return {
        energy, x, p, {n.x, n.y, n.z, momentum.x, momentum.y, 1 / length(x), dot(n, p), 0}, {energy, momentum.z, 0, 0}};
}
Light random_light(const KerrHole& hole, std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> even(-1, 1);
    const auto any = [&] { return Vec3{even(random), even(random), even(random)}; };
    Vec3 x = any();
    x = (reach / length(x)) * x;
    return light_at(hole, x, normalized(any()));
}

FlowTask<double> task_of(const Light& light, double length) {
    FlowTask<double> task{};
    task.ray = light.ray, task.start = light.state, task.length = length;
    task.j_weight = 0.5, task.u_weight = 0.7, task.c_weight = 0.9;
    return task;
}

bool same(const FlowTask<double>& a, const FlowTask<double>& b) {
    const auto number = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return std::ranges::equal(a.end, b.end, number) && number(a.fifth, b.fifth) && number(a.third, b.third);
}
bool same(const KerrRay& a, const KerrRay& b) {
    const auto number = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    const auto crossing = [&](const PlaneCrossing& x, const PlaneCrossing& y) {
        return x.along == y.along && x.r == y.r && x.phi == y.phi && x.climb == y.climb && x.delay == y.delay;
    };
    return a.fate == b.fate && number(a.sky.x, b.sky.x) && number(a.sky.y, b.sky.y) && number(a.sky.z, b.sky.z) &&
           number(a.phi_inf, b.phi_inf) && number(a.delay, b.delay) && a.energy == b.energy && a.l_z == b.l_z &&
           std::ranges::equal(a.crossings, b.crossings, crossing);
}

}  // namespace

TEST_CASE("kerr flow: Hamilton's equations are those of Kerr and Schild's coordinates") {
    constexpr double kSame = 1e-13;  // of the largest: rounding of what the chart's form is a difference of
    std::mt19937 random(1);
    double worst = 0, clocks = 0;
    for (const KerrHole& hole : {KerrHole(0.9), KerrHole(0.998), KerrHole(0.6, 0.7), KerrHole(0)})
        for (const double reach : {0.8, 1.3, 2.0, 5.0, 20.0})
            for (int i = 0; i < 20; ++i) {
                const KerrChart chart{hole};
                Light light = random_light(hole, random, std::max(reach, 1.1 * hole.outer()));
                const KerrChart::Pull pull = chart.pull(light.energy, light.x, light.p);
                const Vec3 v = light.p + pull.drift, n = normalized(light.x);
                const double far = length(light.x), far2 = far * far;
                const Vec3 turn = far * (v - dot(n, v) * n),
                           torque = far2 * (cross(v, light.p) + cross(light.x, pull.force));
                const double in = -dot(n, v), push = far2 * dot(n, pull.force) + dot(light.p, turn);
                const std::array expected{turn.x, turn.y, turn.z, torque.x, torque.y, in, push};
                const double scale =
                    far * length(v) + far2 * length(cross(v, light.p)) + far2 * far * length(pull.force);
                FlowState<double> d;
                KerrFlow(hole).slope(light.ray, light.state, d);
                for (std::size_t k = 0; k < expected.size(); ++k)
                    worst = std::max(worst, std::abs(d[k] - expected[k]) / scale);
                CHECK(std::abs(torque.z) < kSame * scale);
                // t; energy t - x p; and that with 2 energy ln u
                const double t = far2 * (light.energy + pull.delay), logarithm = 2 * light.energy * in / light.state[5];
                const double rest = light.energy * t - far2 * (dot(light.p, v) + dot(light.x, pull.force));
                clocks = std::max(clocks, std::abs(d[7] - t) / t);
                light.ray.far = 1;
                KerrFlow(hole).slope(light.ray, light.state, d);
                clocks = std::max(clocks, std::abs(d[7] - rest) / (scale + t));
                light.ray.logarithm = 1;
                KerrFlow(hole).slope(light.ray, light.state, d);
                clocks = std::max(clocks, std::abs(d[7] - rest - logarithm) / (scale + t));
            }
    fmt::print("kerr flow: slopes by {:.1e}, clocks by {:.1e}\n", worst, clocks);
    CHECK(worst < kSame);
    CHECK(clocks < kSame);
}

TEST_CASE("kerr flow: far away nothing is divided by the distance's smallness") {
    // In flat space n' = J cross n, J' = 0, u' = -c, c' = J^2 u. What a hole adds is of order u.
    for (const double far : {1e6, 1e9, 1e15, 1e30}) {
        const double u = 1 / far, j = 3, c = -std::sqrt((1 - j * u) * (1 + j * u));
        const KerrFlow flow(KerrHole(0.9, 0.3));
        FlowState<double> d;
        flow.slope({1, j * 0.6, 1, 0}, {1, 0, 0, 0, -j * 0.8, u, c, 0}, d);
        CAPTURE(far);
        CHECK(std::abs(d[1] - j * 0.6) < 4 * u + 1e-15);
        CHECK(std::abs(d[2] - j * 0.8) < 4 * u + 1e-15);
        CHECK(std::hypot(d[3], d[4]) < 40 * u);
        CHECK(std::abs(d[5] + c) < 4 * u + 1e-15);
        CHECK(std::abs(d[6]) < 100 * u + 1e-15);
        CHECK(std::isfinite(d[7]));
    }
}

TEST_CASE("kerr step: of eighth order, and it knows its error") {
    const KerrHole hole(0.9);
    const KerrFlow flow(hole);
    std::mt19937 random(2);
    int seen = 0;
    for (int i = 0; i < 12; ++i) {
        const Light light = random_light(hole, random, 4);
        const auto end = [&](double whole, int parts) {
            FlowTask<double> task = task_of(light, whole / parts);
            for (int k = 0; k < parts; ++k) {
                FlowStep<double>(flow, task);
                task.start = task.end;
            }
            return task.end;
        };
        const auto apart = [](const FlowState<double>& a, const FlowState<double>& b) {
            double most = 0;
            for (std::size_t n = 0; n + 1 < kFlowSize; ++n) most = std::max(most, std::abs(a[n] - b[n]));
            return most;
        };
        constexpr double kWhole = 0.25;  // of rays that it turns by up to a radian
        const auto exact = end(kWhole, 64);
        const double one = apart(end(kWhole, 2), exact), half = apart(end(kWhole, 4), exact);
        CAPTURE(one);
        CAPTURE(half);
        if (half > 1e-14) {
            CHECK(one / half > 80);  // 2^8, and how far from small the steps are
            ++seen;
        }
        FlowTask<double> task = task_of(light, kWhole / 2);
        FlowStep<double>(flow, task);
        CHECK(step_error(task, 1) > 0.01 * one);
    }
    FlowTask<double> task = task_of(random_light(hole, random, 4), 0.1);
    CHECK(seen > 6);
    // What is no number is no good step.
    task.start[6] = NAN;
    FlowStep<double>(flow, task);
    CHECK_FALSE(step_error(task, 1) <= 1);
    CHECK(next_step(step_error(task, 1)) == 0.2);
}

TEST_CASE("kerr lanes: steps of every width are those of one ray, bit for bit, ragged ends too") {
    const KerrHole hole(0.95, 0.2);
    const KerrFlow flow(hole);
    std::mt19937 random(3);
    int widths = 0;
    for (const FlowSteps steps : all_flow_steps()) {
        if (steps == nullptr) continue;
        ++widths;
        for (std::size_t count = 1; count <= 19; ++count) {
            std::vector<FlowTask<double>> tasks, alone;
            for (std::size_t i = 0; i < count; ++i) {
                Light light = random_light(hole, random, i % 5 == 4 ? 0.3 : 1 + 3.0 * static_cast<double>(i));
                light.ray.far = i % 2 == 0 ? 1 : 0, light.ray.logarithm = i % 4 == 0 ? 1 : 0;
                tasks.push_back(task_of(light, 0.01 * static_cast<double>(i + 1)));
            }
            alone = tasks;
            std::vector<FlowTask<double>*> some;
            for (FlowTask<double>& task : tasks) some.push_back(&task);
            steps(flow, some.data(), count);
            for (std::size_t i = 0; i < count; ++i) {
                FlowStep<double>(flow, alone[i]);
                CAPTURE(count);
                CAPTURE(i);
                CHECK(same(tasks[i], alone[i]));
            }
        }
    }
    fmt::print("kerr lanes: {} widths on this machine\n", widths);
    CHECK(widths >= 1);
}

namespace {

// By ingoing components, of a camera without angular momentum.
KerrPhoton photon_at(const KerrHole& hole, double r, double theta, Vec3 direction) {
    const double a = hole.a, sine = std::sin(theta), sigma = r * r + a * a * std::cos(theta) * std::cos(theta),
                 across = r * r + a * a, delta = hole.delta(r), mass_r = hole.twice_mass(r) * r,
                 area = across * sigma + a * a * mass_r * sine * sine;
    const double p_t = std::sqrt(area / (delta * sigma)), p_r = -direction.x * std::sqrt(delta / sigma),
                 around = sine * a * mass_r / area * p_t - direction.z * std::sqrt(sigma / area);
    return {r,
            theta,
            0.3,
            {p_t + across / delta * p_r, p_r, -direction.y / std::sqrt(sigma), around + sine * a / delta * p_r}};
}

}  // namespace

TEST_CASE("kerr lanes: many rays are those traced one by one, bit for bit") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> even(-1, 1);
    for (const double r : {0.8, 1.2, 6.0, 1e4})
        for (const std::size_t count : {1u, 7u, 8u, 29u}) {
            const KerrHole hole(0.9);
            std::vector<KerrPhoton> photons;
            for (std::size_t i = 0; i < count; ++i) {  // half of them inward, and half of those near the hole
                const double across = i % 4 < 2 ? 4 / (4 + r) : 1;
                photons.push_back(photon_at(
                    hole, r, 1.2, normalized({i % 2 == 0 ? -1.0 : 1.0, across * even(random), across * even(random)})));
            }
            int shown = 0;
            const std::vector<KerrWatch> watches(count, [&](const KerrStep&) { ++shown; });
            const std::vector<KerrRay> rays = trace_kerr(hole, photons, 3),
                                       seen = trace_kerr(hole, photons, 3, false, watches);
            const int together = shown;
            shown = 0;
            REQUIRE(rays.size() == count);
            for (std::size_t i = 0; i < count; ++i) {
                CAPTURE(r);
                CAPTURE(i);
                CHECK(same(rays[i], trace_kerr(hole, photons[i], 3)));
                CHECK(same(seen[i], trace_kerr(hole, photons[i], 3, false, watches[i])));
            }
            CHECK(shown == together);
        }
}

TEST_CASE("kerr lanes: a frame's rays are those asked for one by one, what they meet too, and inside the horizon") {
    for (const double r : {0.6, 1.3, 9.0}) {
        Scene scene;
        scene.spacetime = {"kerr", {{"spin", 0.9}}};
        scene.camera.observer = r < 1 ? ObserverKind::kRain : ObserverKind::kZamo;
        scene.camera.r = r, scene.camera.theta = 1.3, scene.camera.width = 13, scene.camera.height = 7;
        scene.camera.plane_width = 3;
        scene.disc = DiscSpec{}, scene.disc->inner = 2, scene.disc->outer = 5, scene.disc->opacity = 0.5;
        add(scene, BallSpec{{-3, 0.4, 1.2}, 0.5});
        const auto tracer = FrameTracer::make(scene);
        REQUIRE(tracer);
        std::vector<std::array<double, 2>> positions;
        for (int y = 0; y < scene.camera.height; ++y)
            for (int x = 0; x < scene.camera.width; ++x) positions.push_back({x + 0.5, y + 0.5});
        const std::vector<RayPixel> pixels = tracer->pixels(positions);
        int hits = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const RayPixel a = pixels[i], b = tracer->pixel(positions[i][0], positions[i][1]);
            CHECK(a.fate == b.fate);
            CHECK(a.hit == b.hit);
            CHECK(a.sky == b.sky);
            CHECK(std::array{a.u, a.v, a.w, a.delay, a.g} == std::array{b.u, b.v, b.w, b.delay, b.g});
            hits += a.hit != 0;
        }
        CHECK(hits > 0);
    }
}

TEST_CASE("kerr flow: without spin wide rays from anywhere have the closed forms' directions and times") {
    constexpr double kDirection = 1e-13, kTime = 1e-8, kRoundings = 4 * 2.3e-16;  // rad; r_s/c; of the way
    Scene scene;
    double directions = 0, times = 0;
    for (const double r : {3.0, 30.0, 1e4, 1e7, 1e9})
        for (const double beta : {1e-3, 0.02, 0.4, 1.2, 1.57, 2.0, 3.1}) {
            RayQuery query;
            query.r = r, query.theta = 1.1, query.phi = 0.4;
            query.n = normalized(Vec3{-std::cos(beta), 0.6 * std::sin(beta), 0.8 * std::sin(beta)});
            const auto exact = trace_ray(scene, query, 0);
            const KerrRay ray = trace_kerr(0, {query.r, query.theta, query.phi, query.n}, 0);
            REQUIRE(exact);
            CAPTURE(r);
            CAPTURE(beta);
            REQUIRE(exact->fate == ray.fate);
            if (ray.fate != Fate::kEscaped) continue;
            directions = std::max(directions, length(exact->sky - ray.sky));
            times = std::max(times, std::abs(exact->delay - ray.delay) / (kTime + kRoundings * r));
        }
    fmt::print("kerr flow: wide rays without spin off by {:.1e} rad, T by {:.2f} of what is stated\n", directions,
               times);
    CHECK(directions < kDirection);
    CHECK(times < 1);
}

TEST_CASE("kerr flow: next to the axis azimuths have no leap of a turn, where a ray is dragged against its L_z too") {
    double most = 0;
    int rays = 0;
    for (const double spin : {0.5, 0.998})
        for (const double l : {0.05, -0.05, 0.02, -0.02})
            for (const double across : {-2.8, -2.3, 2.4, 2.6, 4.0})
                for (const double theta : {0.4, 1.3}) {
                    constexpr double kFrom = 20;
                    const Vec3 look = normalized({-1, across / kFrom, l / kFrom});
                    double before = NAN;
                    const KerrRay ray =
                        trace_kerr(KerrHole(spin), KerrStart{kFrom, theta, 0, look}, 0, [&](const KerrStep& step) {
                            if (std::min(step.begin.r, step.end.r) < 1.1) return;
                            for (int i = 0; i <= 128; ++i) {
                                const double phi = i == 0 ? step.begin.phi
                                                   : i == 128
                                                       ? step.end.phi
                                                       : step.at(step.from + (step.to - step.from) * i / 128).phi;
                                if (before == before) most = std::max(most, std::abs(phi - before));
                                before = phi;
                            }
                        });
                    ++rays;
                    if (ray.fate == Fate::kEscaped) most = std::max(most, std::abs(ray.phi_inf - before));
                }
    fmt::print("kerr flow: {} rays past the axis, azimuths by at most {:.2f} rad from place to place\n", rays, most);
    CHECK(most < 2.5);
}
