#include "render/ball_paths.h"

#include <algorithm>
#include <array>

#include "observer/ball_motion.h"
#include "observer/observer.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "shaderlib/body_text.h"

namespace nullscope {
namespace {

constexpr double kBent = 60.0;     // r_s/c: what bending adds to the straight way, logarithm and half turns of 8.2 each
constexpr double kFalling = 12.0;  // the clock of a camera that falls is that much behind at most

constexpr double kBendBetween = 1.2;  // of the most within a cell over its mean

// row: 8 numbers a node.
BallPath sampled(const BallMotionAt& motion, const Scene& scene, double radius, double reach, float* row) {
    const double r = std::fabs(scene.camera.r);
    BallPath path;
    path.from = scene.light.delay ? std::max(r - reach, 0.0) - (falls(scene.camera) ? kFalling : 0.0) : -1.0;
    const double to = scene.light.delay ? r + reach + kBent : 1.0;
    path.step = (to - path.from) / kBallPathCells;
    const auto put = [&](int i) {
        const BallPlace ball = motion(scene.time - path.from - i * path.step);
        const auto write = [&](int line, Vec3 v) {
            float* out = row + 4 * (line * (kBallPathCells + 1) + i);
            out[0] = static_cast<float>(v.x), out[1] = static_cast<float>(v.y), out[2] = static_cast<float>(v.z);
        };
        write(0, ball.place);
        write(1, -path.step * ball.velocity);
        path.reach = std::max(path.reach, length(ball.place) + radius);
        path.least_radius =
            std::min(path.least_radius, length(ball.place) - radius - path.step * length(ball.velocity));
        path.height = std::max(path.height, std::fabs(ball.place.z) + radius + path.step * std::fabs(ball.velocity.z));
        path.speed = std::max(path.speed, length(ball.velocity));
    };
    if (scene.time > path.from)  // away from t = 0, where free-fall integration starts
        for (int i = kBallPathCells; i >= 0; --i) put(i);
    else
        for (int i = 0; i <= kBallPathCells; ++i) put(i);
    const auto velocity = [&](int i) {
        const float* v = row + 4 * (kBallPathCells + 1 + i);
        return Vec3{v[0], v[1], v[2]} / path.step;
    };
    std::array<double, kBallPathCells> bends{};
    for (int i = 0; i < kBallPathCells; ++i)
        bends[static_cast<std::size_t>(i)] = kBendBetween * length(velocity(i + 1) - velocity(i)) / path.step;
    for (int i = 0; i <= kBallPathCells; ++i) {
        const auto first = bends.begin() + std::min(i, kBallPathCells - 1),
                   last = bends.begin() + std::min(i + kBallPathAhead, kBallPathCells);
        row[4 * i + 3] = static_cast<float>(*std::max_element(first, last));
    }
    return path;
}

}  // namespace

Result<BallPaths> ball_paths(const Spacetime& spacetime, const Scene& scene) {
    constexpr std::size_t kBallFloats = 8 * static_cast<std::size_t>(kBallPathCells + 1);
    BallPaths paths;
    if (const auto late = late_fall_faults(spacetime.rotates(), scene); !late.empty())
        return bad_key(late.front().key, late.front().what, late.front().allowed);
    for (const std::size_t i : shader_bodies(scene)) {
        const auto* ball = std::get_if<BallSpec>(&scene.bodies[i].shape);
        if (ball == nullptr || !ball->moves()) continue;
        const auto motion = ball_motion(spacetime, *ball);
        if (!motion) return within(body_section(scene, i), motion.error());
        paths.rows.texels.resize(paths.rows.texels.size() + kBallFloats, 0.0f);
        float* row = paths.rows.texels.data() + paths.rows.texels.size() - kBallFloats;
        constexpr int kTries = 4;              // a ball that goes farther than was thought is seen for longer
        constexpr double kFarther = 1 + 1e-9;  // rounding puts a circle's points on either side of its radius
        double reach = length((*motion)(scene.time).place) + ball->radius;
        BallPath path = sampled(*motion, scene, ball->radius, reach, row);
        for (int k = 0; k < kTries && path.reach > kFarther * reach; ++k)
            path = sampled(*motion, scene, ball->radius, reach = 1.05 * path.reach, row);
        paths.balls.emplace(i, path);
    }
    paths.rows.width = kBallPathCells + 1;
    paths.rows.height = 2 * static_cast<int>(paths.balls.size());
    return paths;
}

}  // namespace nullscope
