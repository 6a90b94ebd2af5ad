#include "viewer/additions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/bodies.h"
#include "scenefile/scene_edit.h"
#include "viewer/fly_camera.h"
#include "viewer/view_state.h"

namespace nullscope::viewer {
namespace {

struct Paint {
    Vec3 bright, dark;  // linear light
};
constexpr std::array kPaints = {
    Paint{{0.75, 0.42, 0.20}, {0.30, 0.13, 0.06}}, Paint{{0.16, 0.36, 0.75}, {0.03, 0.09, 0.25}},
    Paint{{0.62, 0.60, 0.52}, {0.22, 0.20, 0.17}}, Paint{{0.22, 0.52, 0.28}, {0.05, 0.16, 0.09}},
    Paint{{0.72, 0.24, 0.16}, {0.24, 0.06, 0.04}}, Paint{{0.70, 0.62, 0.30}, {0.26, 0.20, 0.08}}};
constexpr double kFirstTurn = 0.35;    // rad, of where planets lie about the picture's middle ...
constexpr double kNextTurn = 2.39996;  // ... and from each to the next: the golden angle
constexpr double kAside = 0.5;         // of half the field of view
constexpr double kSize = 0.05;         // radius over distance, of the first; others are smaller or larger

Body planet(const Scene& scene, double share) {
    const auto count = static_cast<double>(std::ranges::count_if(scene.bodies, has_shape<BallSpec>));
    const FlyCamera camera = fly_camera(scene.camera);
    const double away = share * std::fabs(scene.camera.r), turn = kFirstTurn + kNextTurn * count;
    const double aside = std::tan(kAside * 0.5 * std::min(fov_of(scene.camera), 1.6));
    const Vec3 seen{aside * std::cos(turn), 0.5 * aside * std::sin(turn), -1.0};
    const Vec3 position = scene.camera.r * camera.place + away * (camera.world_from_camera * seen);
    BallSpec ball;
    ball.position = position;
    ball.radius = away * kSize * (1.0 + 0.35 * std::sin(2.0 * count));
    Body body{.shape = ball};
    const Paint& paint = kPaints[static_cast<std::size_t>(count) % kPaints.size()];
    body.material.texture = TextureKind::kNoise;
    body.material.colour = paint.bright, body.material.second_colour = paint.dark;
    body.material.night = 0.15;
    body.material.sun_longitude = scene.camera.phi - 0.9, body.material.sun_latitude = 0.3;
    return body;
}

}  // namespace

Result<Scene> with_addition(const Scene& scene, std::string_view section) {
    constexpr double kShares[] = {0.55, 0.4, 0.25};  // of the camera's r, where the planet is before it
    for (const double share : kShares) {
        if (section != BallSpec::kName) break;
        Scene placed = scene;
        placed.bodies.push_back(planet(scene, share));
        if (auto good = savable(placed)) return good;
    }
    return with_section(scene, section);
}

}  // namespace nullscope::viewer
