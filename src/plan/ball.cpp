// A sphere anywhere, at rest or on its way.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "plan/body_kind.h"

namespace nullscope {
namespace {

const BallSpec& ball_of(const Body& body) { return std::get<BallSpec>(body.shape); }

template <BallMotion motion>
bool moves(const Scene& s) {
    return last_body<BallSpec>(s).motion == motion;
}

std::vector<SceneKey> ball_keys() {
    return {
        {"ball", "position", KeyType::kPoint, "r_s", "[-12, 0, 0]", closed(-1e6, 1e6), "", "Its centre: x, y, z.",
         [](auto& s) { return &last_body<BallSpec>(s).position; }},
        {"ball", "radius", KeyType::kNumber, "r_s", "2", kPositive, "",
         "Radius; must contain neither the coordinate centre nor, at rest, the camera. A ball that moves over "
         "the camera is not seen from inside.",
         [](auto& s) { return &last_body<BallSpec>(s).radius; }},
        {"ball", "motion", KeyType::kChoice, "", "still", kNoRange, "still orbit geodesic path",
         "How its centre moves: not; on the circular geodesic through position; in free fall from position; "
         "or by formulas of t.",
         [](auto& s) { return &last_body<BallSpec>(s).motion; }},
        {"ball", "sense", KeyType::kChoice, "", "eastward", kNoRange, kOrbitSenses,
         "Which way it goes round, as disc.sense; needs motion = \"orbit\".",
         [](auto& s) { return &last_body<BallSpec>(s).sense; }, moves<BallMotion::kOrbit>, "motion = \"orbit\""},
        {"ball", "velocity", KeyType::kVelocity, "c", "[0, 0, 0]", kNoRange, "",
         "Velocity at position and t = 0, along (e_r, e_theta, e_phi) of an observer at rest there; needs motion = "
         "\"geodesic\".",
         [](auto& s) { return &last_body<BallSpec>(s).velocity; }, moves<BallMotion::kGeodesic>,
         "motion = \"geodesic\""},
        {"ball", "x", KeyType::kFormula, "", "", kNoRange, "t", "x of its centre at time t; needs motion = \"path\".",
         [](auto& s) { return &last_body<BallSpec>(s).x; }, moves<BallMotion::kPath>, "motion = \"path\"", true},
        {"ball", "y", KeyType::kFormula, "", "", kNoRange, "t", "As x.",
         [](auto& s) { return &last_body<BallSpec>(s).y; }, moves<BallMotion::kPath>, "motion = \"path\"", true},
        {"ball", "z", KeyType::kFormula, "", "", kNoRange, "t", "As x.",
         [](auto& s) { return &last_body<BallSpec>(s).z; }, moves<BallMotion::kPath>, "motion = \"path\"", true},
    };
}

void check_ball(const Body& body, const BodyCheck& at) {
    const BallSpec& ball = ball_of(body);
    if (ball.motion == BallMotion::kPath) return;
    if (!(length(ball.position) > ball.radius))
        at.report({"radius", "the centre lies within the ball",
                   "radius below the distance of position from the centre ([sphere] is centred)"});
    else if (!ball.moves() && at.camera_is_there(body.far) && !(length(at.camera() - ball.position) > ball.radius))
        at.report({"radius", "the camera is inside of the ball", "a ball beside the camera"});
}

}  // namespace

const BodyKind kBallKind{
    .key = BallSpec::kName,
    .effect = {Effect::kBall, "ball", "EFFECT_BALL", "A solid sphere anywhere ends rays.", "there is a [ball]",
               "steps along the ray, at most 128, shared with other bodies"},
    .make = [] { return Body{BallSpec{}}; },
    .keys = ball_keys,
    .check = check_ball,
    .words =
        [](const Body& body) {
            const BallSpec& b = ball_of(body);
            return fmt::format("of radius {} at [{}, {}, {}]", b.radius, b.position.x, b.position.y, b.position.z);
        },
    .extent =
        [](const Body& body) {
            const BallSpec& b = ball_of(body);
            return BodyExtent{length(b.position) - b.radius, length(b.position) + b.radius, b.radius,
                              std::fabs(b.position.z) + b.radius};
        },
    .size = [](const Body& body) { return ball_of(body).radius; },
    .moves = [](const Body& body) { return ball_of(body).moves() ? "motion" : nullptr; },
};

}  // namespace nullscope
