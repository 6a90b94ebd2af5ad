// The reference's light of bodies lit by a far sun. The shader's is compared with it by the golden pictures of earth and saturn.
#include <doctest/doctest.h>

#include <cmath>

#include "reference/bodies.h"

namespace {

using namespace nullscope;

constexpr double kRounding = 1e-12;

TEST_CASE("body light: by a far sun, Lambert's law on the day's side and what is left on the night's") {
    Scene scene;
    Body& body = scene.bodies.emplace_back();
    body.shape = SphereSpec{};
    body.material.night = 0.2, body.material.sun_longitude = 0.5, body.material.sun_latitude = -0.3;
    const Vec3 sun{std::cos(-0.3) * std::cos(0.5), std::cos(-0.3) * std::sin(0.5), std::sin(-0.3)};
    const Vec3 aside{-std::sin(0.5), std::cos(0.5), 0};
    reference::BodyHit hit{};
    hit.cosine = 1, hit.place = {1, 0, 0};
    const auto light = [&](double angle) {
        hit.normal = std::cos(angle) * sun + std::sin(angle) * aside;
        return reference::body_light(scene, hit, nullptr).x;
    };
    const double noon = body.material.colour.x;
    CHECK(std::abs(light(0) - noon) < kRounding);
    CHECK(std::abs(light(M_PI / 3) - (0.2 + 0.8 * 0.5) * noon) < kRounding);
    CHECK(std::abs(light(M_PI / 2) - 0.2 * noon) < kRounding);
    CHECK(std::abs(light(2.5) - 0.2 * noon) < kRounding);
    body.material.night = 1;
    CHECK(std::abs(light(2.5) - noon) < kRounding);
}

}  // namespace
