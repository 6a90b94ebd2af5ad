// What a user adds stands where it is seen, in every scene that ships.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "studio/additions.h"
#include "studio/fly_camera.h"
#include "studio/view_state.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

TEST_CASE("additions: planets are in front of the camera, apart from each other, and the scene can be saved") {
    for (const SceneInfo& info : shipped_scenes()) {
        CAPTURE(info.name);
        auto scene = load_scene(info.path.string());
        REQUIRE(scene);
        const auto spacetime = spacetime_of(*scene);
        if (!spacetime->can_have_bodies() || spacetime->by_proper_length() || scene->bodies.size() + 2 > kMostBodies)
            continue;
        std::vector<Vec3> seen;
        for (int i = 0; i < 2; ++i) {
            const auto more = with_addition(*scene, "ball");
            if (!more) {
                CHECK_MESSAGE(!more.error().message().empty(), "refused in words");
                break;
            }
            scene = *more;
            const auto last = std::find_if(scene->bodies.rbegin(), scene->bodies.rend(), has_shape<BallSpec>);
            REQUIRE(last != scene->bodies.rend());
            const auto* ball = std::get_if<BallSpec>(&last->shape);
            const FlyCamera camera = fly_camera(scene->camera);
            const Vec3 to = transposed(camera.world_from_camera) * (ball->position - scene->camera.r * camera.place);
            CHECK(to.z < 0.0);
            CHECK(std::fabs(to.x / to.z) < 0.5 * scene->camera.plane_width / scene->camera.focal_distance);
            seen.push_back(to / -to.z);
        }
        if (seen.size() == 2) CHECK(length(seen[0] - seen[1]) > 0.01 * scene->camera.plane_width);
    }
}

TEST_CASE("additions: planets lie in the part of the picture that no panel covers") {
    auto scene = load_scene("first-light");
    REQUIRE(scene);
    const FreePart free{0.3, 0.6, 0.1, 0.5};
    for (int i = 0; i < 6; ++i) {
        scene = with_addition(*scene, "ball", free);
        REQUIRE(scene);
        const auto& ball = std::get<BallSpec>(scene->bodies.back().shape);
        const CameraSpec& camera = scene->camera;
        const FlyCamera at = fly_camera(camera);
        const Vec3 to = transposed(at.world_from_camera) * (ball.position - camera.r * at.place);
        const double across = camera.plane_width / camera.focal_distance, size = ball.radius / -to.z / across;
        const double x = 0.5 - to.x / to.z / across, y = 0.5 + to.y / to.z / across * camera.width / camera.height,
                     tall = size * camera.width / camera.height;
        CHECK(x - size > free.left);
        CHECK(x + size < free.right);
        CHECK(y - tall > free.top);
        CHECK(y + tall < free.bottom);
    }
}

}  // namespace
