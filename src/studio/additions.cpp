#include "studio/additions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/bodies.h"
#include "scenefile/scene_edit.h"
#include "studio/fly_camera.h"
#include "studio/view_state.h"

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
constexpr double kAside = 0.5;         // of half the free part
constexpr double kSize = 0.05;         // radius over distance, of the first; others are smaller or larger
constexpr double kMostSize = 0.4;      // likewise, of half the free part
constexpr double kWidestAddition =
    1.0;  // tangent of half a field of view: planets of wider ones are nearer to the middle

Body planet(const Scene& scene, double share, const FreePart& free) {
    const auto count = static_cast<double>(std::ranges::count_if(scene.bodies, has_shape<BallSpec>));
    const FlyCamera camera = fly_camera(scene.camera);
    const double away = share * std::fabs(scene.camera.r), turn = kFirstTurn + kNextTurn * count;
    const CameraSpec& lens = scene.camera;
    const double x = std::min(0.5 * lens.plane_width / lens.focal_distance, kWidestAddition),
                 y = x * lens.height / lens.width;
    const double half_width = x * (free.right - free.left), half_height = y * (free.bottom - free.top);
    const Vec3 seen{x * (free.left + free.right - 1.0) + kAside * half_width * std::cos(turn),
                    y * (1.0 - free.top - free.bottom) + kAside * half_height * std::sin(turn), -1.0};
    const Vec3 position = scene.camera.r * camera.place + away * (camera.world_from_camera * seen);
    BallSpec ball;
    ball.position = position;
    ball.radius =
        away * std::min(kSize * (1.0 + 0.35 * std::sin(2.0 * count)), kMostSize * std::min(half_width, half_height));
    Body body{.shape = ball};
    const Paint& paint = kPaints[static_cast<std::size_t>(count) % kPaints.size()];
    body.material.texture = TextureKind::kNoise;
    body.material.colour = paint.bright, body.material.second_colour = paint.dark;
    body.material.night = 0.15;
    body.material.sun_longitude = scene.camera.phi - 0.9, body.material.sun_latitude = 0.3;
    return body;
}

}  // namespace

Result<Scene> with_addition(const Scene& scene, std::string_view section, const FreePart& free) {
    constexpr double kShares[] = {0.55, 0.4, 0.25};  // of the camera's r, where the planet is before it
    for (const double share : kShares) {
        if (section != BallSpec::kName) break;
        Scene placed = scene;
        placed.bodies.push_back(planet(scene, share, free));
        if (auto good = savable(placed)) return good;
    }
    return with_section(scene, section);
}

}  // namespace nullscope::viewer
