#include "render/ball_path.h"

#include <algorithm>

#include "scene/ball_motion.h"
#include "scene/observer.h"

namespace nullscope {
namespace {

constexpr double kBent = 60.0;     // r_s/c: what bending adds to the straight way, logarithm and half turns of 8.2 each
constexpr double kFalling = 12.0;  // the clock of a camera that falls is that much behind at most

BallPath sampled(const BallMotionAt& motion, const Scene& scene, double reach) {
    const double r = std::fabs(scene.camera.r);
    BallPath path{{kBallPathCells + 1, 2, {}},
                  scene.light.delay ? std::max(r - reach, 0.0) - (falls(scene.camera) ? kFalling : 0.0) : -1.0,
                  0,
                  0,
                  0};
    const double to = scene.light.delay ? r + reach + kBent : 1.0;
    path.step = (to - path.from) / kBallPathCells;
    path.row.texels.assign(8 * static_cast<std::size_t>(kBallPathCells + 1), 0.0f);
    const auto put = [&](int i) {
        const BallPlace ball = motion(scene.time - path.from - i * path.step);
        const auto write = [&](int row, Vec3 v) {
            float* out = path.row.texels.data() +
                         4 * (static_cast<std::size_t>(row) * (kBallPathCells + 1) + static_cast<std::size_t>(i));
            out[0] = static_cast<float>(v.x), out[1] = static_cast<float>(v.y), out[2] = static_cast<float>(v.z);
        };
        write(0, ball.place);
        write(1, -path.step * ball.velocity);
        path.reach = std::max(path.reach, length(ball.place) + scene.ball->radius);
        path.ground =
            std::min(path.ground, length(ball.place) - scene.ball->radius - path.step * length(ball.velocity));
        path.speed = std::max(path.speed, length(ball.velocity));
    };
    if (scene.time > path.from)  // away from t = 0, whence falls are followed
        for (int i = kBallPathCells; i >= 0; --i) put(i);
    else
        for (int i = 0; i <= kBallPathCells; ++i) put(i);
    return path;
}

}  // namespace

Result<BallPath> ball_path(const Spacetime& spacetime, const Scene& scene) {
    const auto motion = ball_motion(spacetime, *scene.ball);
    if (!motion) return motion.error();
    constexpr int kTries = 4;  // a ball that goes farther than was thought is seen for longer
    double reach = length((*motion)(scene.time).place) + scene.ball->radius;
    BallPath path = sampled(*motion, scene, reach);
    for (int i = 0; i < kTries && path.reach > reach; ++i) path = sampled(*motion, scene, reach = 1.05 * path.reach);
    return path;
}

}  // namespace nullscope
