// Bodies about a rotating hole against Carter's potentials of r and theta: how far in and how high a ray comes.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "kerr_bodies.h"
#include "scene/bodies.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;
using reference::KerrStart;
using reference::KerrStep;

double horizon_of(double spin) { return 0.5 * (1 + std::sqrt((1 - spin) * (1 + spin))); }

// Carter's constants of a ray that the camera without angular momentum sees from `direction`.
struct Carter {
    double a, e, l, k;  // k = Q + (L - a E)^2
    Carter(double spin, const KerrStart& start) : a(0.5 * spin) {
        const double sine = std::sin(start.theta), cosine = std::cos(start.theta), r = start.r;
        const double sigma = r * r + a * a * cosine * cosine, delta = r * r - r + a * a,
                     area = (r * r + a * a) * (r * r + a * a) - delta * a * a * sine * sine;
        l = -std::sqrt(area / sigma) * sine * start.direction.z, e = std::sqrt(delta * sigma / area) + a * r / area * l;
        k = sigma * start.direction.y * start.direction.y + std::pow(l / sine - a * e * sine, 2);
    }
    // The largest cos(theta)^2 that a ray can come to: Q + u (a^2 E^2 - Q - L^2) - a^2 E^2 u^2 = 0.
    double highest() const {
        const double q = k - std::pow(l - a * e, 2), b = a * a * e * e - q - l * l,
                     root = std::sqrt(b * b + 4 * a * a * e * e * q);
        return b < 0 ? 2 * q / (root - b) : (root + b) / (2 * a * a * e * e);
    }
};

// How far in a ray gets by R(r), or 0 at the horizon.
double least_radius(double spin, const KerrStart& start) {
    const Carter c(spin, start);
    const double a = c.a, r0 = start.r;
    const auto potential = [&](double r) {
        return std::pow(c.e * (r * r + a * a) - a * c.l, 2) - (r * r - r + a * a) * c.k;
    };
    if (start.direction.x >= 0) return r0;
    const double horizon = horizon_of(spin);
    constexpr int kLooks = 4000;
    for (int i = 1; i <= kLooks; ++i) {
        const auto at = [&](int j) {
            return horizon + (r0 - horizon) * std::pow(1 - static_cast<double>(j) / kLooks, 3);
        };  // they crowd where light can go round
        if (potential(at(i)) >= 0) continue;
        double high = at(i - 1), low = at(i);
        for (int j = 0; j < 60; ++j) (potential(0.5 * (low + high)) >= 0 ? high : low) = 0.5 * (low + high);
        return high;
    }
    return 0;
}
// The angle to straight inward at which a ray touches a sphere.
double touching_angle(double spin, const std::function<KerrStart(double)>& start, double radius) {
    double low = 0, high = 0.5 * M_PI;
    for (int j = 0; j < 50; ++j)
        (least_radius(spin, start(0.5 * (low + high))) < radius ? low : high) = 0.5 * (low + high);
    return low;
}

}  // namespace

TEST_CASE("kerr bodies: a ray meets a sphere exactly if Carter's potential lets it in so far") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(0, 1);
    double off = 0;
    int hits = 0, clear = 0;
    for (const double spin : {0.9, 0.998})
        for (const double radius : {1.0001 * horizon_of(spin), 1.2, 3.0, 8.0}) {
            Scene sphere = spinning(spin), formula = sphere;
            add(sphere, SphereSpec{radius});
            add(formula, SurfaceSpec{.shape = fmt::format("length(x, y, z) - {}", radius), .bound = 1.01 * radius});
            const auto metric = metric_of(sphere);
            for (int i = 0; i < 12; ++i) {
                const double theta = 0.3 + 2.5 * even(random), around = 2 * M_PI * even(random);
                const auto start = [&](double beta) {
                    return KerrStart{
                        12,
                        theta,
                        0,
                        {-std::cos(beta), std::sin(beta) * std::cos(around), std::sin(beta) * std::sin(around)}};
                };
                const double touching = touching_angle(spin, start, radius);
                for (const double by : {-0.5, -1e-2, -1e-4, -1e-6, 1e-6, 1e-4, 1e-2, 0.5}) {
                    const double beta = by == -0.5 ? 0.5 * touching : touching + by;
                    CAPTURE(spin);
                    CAPTURE(radius);
                    CAPTURE(i);
                    CAPTURE(by);
                    for (const Scene* scene : {&sphere, &formula}) {
                        const Met found = met(*scene, *metric, start(beta));
                        CHECK(found.hit.has_value() == (by < 0));
                        if (!found.hit) {
                            ++clear;
                            continue;
                        }
                        ++hits;
                        off = std::max(off, std::fabs(length(found.hit->place) / radius - 1));
                    }
                }
            }
        }
    fmt::print("spheres: {} rays hit, off by {:.2e} of the radius, {} miss\n", hits, off, clear);
    CHECK(off < kOnSurface);
}

TEST_CASE("kerr bodies: no place on a ray is higher than Carter's potential lets it, and the highest is") {
    constexpr double kFlat = 1e-3;  // what samples a sixteenth of a step apart leave of a maximum
    std::mt19937 random(5);
    std::uniform_real_distribution<double> even(0, 1);
    int turned = 0;
    for (const double spin : {0.9, 0.998})
        for (int i = 0; i < 30; ++i) {
            const double around = 2 * M_PI * even(random), beta = 0.35 * even(random);
            const KerrStart start{
                8,
                1.0 + 1.1 * even(random),
                0,
                {-std::cos(beta), std::sin(beta) * std::cos(around), std::sin(beta) * std::sin(around)}};
            const double highest = Carter(spin, start).highest();
            double most = 0;
            bool within = false;  // of the ray, and near the hole, where the chart's theta is another
            reference::trace_kerr(spin, start, 0, [&](const KerrStep& step) {
                for (int k = 0; k <= 16; ++k) {
                    const reference::KerrPlace place = step.at(step.from + (step.to - step.from) * k / 16);
                    const double height = std::pow(std::cos(place.theta), 2);
                    if (height > most) most = height, within = place.r < 4;
                }
            });
            CHECK(most < highest + 1e-11);
            if (!within || highest > 0.9) continue;
            if (most > highest * (1 - kFlat)) ++turned;
        }
    fmt::print("{} rays turn back from their highest latitude\n", turned);
    CHECK(turned > 5);
}

TEST_CASE("kerr bodies: a sphere that is just touched comes before what stands right behind") {
    constexpr double kSpin = 0.9, kRadius = 6,
                     kBehind = 0.15 / (kRadius * kRadius);  // of the tracer's parameter: 0.15 r_s here
    Scene alone = spinning(kSpin);
    add(alone, SphereSpec{kRadius});
    const auto metric = metric_of(alone);
    for (int i = 0; i < 40; ++i) {
        const double around = 0.1 * i, r0 = 10 + 0.2 * i;  // where steps begin differs
        const auto start = [&](double beta) {
            return KerrStart{
                r0, 1.2, 0, {-std::cos(beta), std::sin(beta) * std::cos(around), std::sin(beta) * std::sin(around)}};
        };
        const KerrStart touching = start(touching_angle(kSpin, start, kRadius) - 1e-7);
        const Met first = met(alone, *metric, touching);
        REQUIRE(first.hit);
        Scene both = alone;
        BallSpec& ball = add(both, BallSpec{.radius = 0.05});
        reference::trace_kerr(kSpin, touching, 0, [&](const KerrStep& step) {
            const double along = first.hit->along + kBehind;
            if (along >= step.from && along <= step.to) ball.position = step.at(along).flat();
        });
        const Met found = met(both, *metric, touching);
        CAPTURE(i);
        REQUIRE(found.hit);
        CHECK(found.hit->number == kSphereHit);
        CHECK(length(found.hit->place - first.hit->place) < 1e-6);
    }
}
