// A sphere that passes at 0.9 c looks like a circle (Penrose 1959, Terrell 1959). Flat space; the camera moves past the ball at rest, which
// is the same thing.
#include <algorithm>
#include <cmath>

#include "observer/pose.h"
#include "scene/bodies.h"
#include "support/gpu_session.h"
#include "support/observer.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kSize = 480;
constexpr double kPromised_px = 0.1;

// The direction, in the frame of a camera that moves with v, of what is seen at n at rest.
Vec3 seen_moving(Vec3 n, Vec3 v) { return aberrate_to_static(n, -1.0 * v).n; }

// Looks at the middle of the circle that the ball's outline makes.
Scene passing_ball(Vec3 velocity) {
    Scene scene;
    scene.spacetime.metric = "minkowski";
    scene.sky.kind = SkyKind::kBlack;
    CameraSpec& camera = scene.camera;
    camera.r = 6.0, camera.theta = M_PI / 2, camera.velocity = velocity;
    camera.width = camera.height = kSize;
    camera.plane_width = 2 * std::tan(45 * M_PI / 180);
    const double radius = add(scene, BallSpec{{0, 2, 0.5}, 1.5}).radius;
    // The cone of the outline at rest, three of its directions as the camera sees them, and the axis of the cone through those.
    const Vec3 to_ball = Vec3{0, 2, 0.5} - Vec3{6, 0, 0};  // world axes; at phi = 0: e_r = x, e_theta = -z, e_phi = y
    const Vec3 axis = normalized(Vec3{to_ball.x, -to_ball.z, to_ball.y});
    const double sine = radius / length(to_ball), cosine = std::sqrt(1 - sine * sine);
    const Vec3 u = normalized(cross(axis, {0, 0, 1})), w = cross(axis, u);
    Vec3 rim[3];
    for (int i = 0; i < 3; ++i) {
        const double turn = 2 * M_PI * i / 3;
        rim[i] = seen_moving(cosine * axis + sine * (std::cos(turn) * u + std::sin(turn) * w), velocity);
    }
    Vec3 middle = normalized(cross(rim[1] - rim[0], rim[2] - rim[0]));
    if (dot(middle, rim[0]) < 0) middle = -1.0 * middle;
    camera.yaw = std::atan2(middle.z, -middle.x);
    camera.pitch = std::atan2(-middle.y, std::hypot(middle.x, middle.z));
    return scene;
}

// Radius of the outline towards `turn`, px, by the reference.
double rim_px(const Scene& scene, double turn) {
    const auto trace = reference_trace(scene);
    double in = 0, out = 0.7 * kSize;
    while (out - in > 1e-6) {
        const double middle = 0.5 * (in + out);
        const auto pixel = trace({{kSize / 2 + middle * std::cos(turn), kSize / 2 + middle * std::sin(turn)}})[0];
        (pixel.fate == Fate::kHit ? in : out) = middle;
    }
    return in;
}

TEST_CASE("terrell: a ball passing at 0.9 c has a round outline, by the reference and by OpenGL") {
    for (const Vec3 velocity : {Vec3{0, 0, 0.9}, Vec3{0, 0, -0.9}, Vec3{-0.5, 0.3, 0.68}}) {
        const Scene scene = passing_ball(velocity);
        double least = 1e9, most = 0;
        for (int i = 0; i < 24; ++i) {
            const double radius = rim_px(scene, 2 * M_PI * i / 24);
            least = std::min(least, radius), most = std::max(most, radius);
        }
        fmt::print("reference: outline between {:.5f} and {:.5f} px from its middle\n", least, most);
        CHECK(most - least < 2 * kPromised_px);
        REQUIRE(least > 10);
        REQUIRE(most < kSize / 2);
        on_every_context([&](GpuSession& session) {
            const RayFrame frame = gl_ray_data(session, scene);
            int wrong = 0, hits = 0;
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const double from = std::hypot(x + 0.5 - kSize / 2, y + 0.5 - kSize / 2);
                    const bool hit = frame.at(x, y).fate == Fate::kHit;
                    hits += hit;
                    wrong += hit ? from > most + kPromised_px : from < least - kPromised_px;
                }
            CHECK(wrong == 0);
            CHECK(std::fabs(hits / (M_PI * least * least) - 1) <
                  1 / least);  // half a pixel on either side of the outline
        });
    }
    // That it can fail: a camera that is no longer turned to the middle.
    Scene aside = passing_ball({0, 0, 0.9});
    aside.camera.yaw += 0.02;
    CHECK(std::fabs(rim_px(aside, 0) - rim_px(aside, M_PI)) > 2 * kPromised_px);
}

// Two motions that are not along one line turn the camera between them (Thomas and Wigner), which is a change of directions too.
TEST_CASE("aberration off: an orbiting camera with a velocity of its own looks where one at rest does") {
    static constexpr double kFloat = 1e-4;  // rad: rounding, next to the shadow; 0.05 and more where the camera turns
    on_one_context([](GpuSession& session) {
        Scene scene;
        scene.camera.width = 16, scene.camera.height = 9, scene.light.aberration = false;
        REQUIRE(session.renderer->prepare(scene));
        const RayFrame still = session.renderer->ray_data();
        scene.camera.observer = ObserverKind::kOrbit, scene.camera.velocity = {-0.3, 0.4, -0.3};
        REQUIRE(session.renderer->prepare(scene));
        const RayFrame moving = session.renderer->ray_data();
        for (std::size_t i = 0; i < still.pixels.size(); ++i) {
            CHECK(moving.pixels[i].fate == still.pixels[i].fate);
            CHECK(length(moving.pixels[i].sky - still.pixels[i].sky) < kFloat);
        }
    });
}

}  // namespace
