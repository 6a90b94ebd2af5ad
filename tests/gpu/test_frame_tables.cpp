// What a frame keeps from the one before it.
#include "render/frame_tables.h"
#include "scene/scene_file.h"
#include "support/gpu_session.h"

using namespace nullscope;

TEST_CASE("a camera that goes round or turns needs no new rows and no new images of the disc") {
    auto scene = load_scene("first-light");
    REQUIRE(scene);
    FrameTables tables;
    REQUIRE(tables.update(*scene));
    REQUIRE(tables.critical_images() != nullptr);
    const int rows = tables.revision(), images = tables.critical_images_made();
    const auto numbers = [&](const FrameTables& from, const CriticalImages* known) {
        return frame_numbers(*scene, from.spacetime(), from.fan(), {}, &from.matter(), from.ball_path(), known);
    };
    const auto check_same_as_anew = [&] {
        FrameTables fresh;
        REQUIRE(fresh.update(*scene));
        CHECK(numbers(tables, tables.critical_images()) == numbers(fresh, nullptr));
    };
    for (int i = 0; i < 3; ++i) {
        scene->camera.phi += 0.4, scene->camera.theta -= 0.1, scene->time += 1.0;
        REQUIRE(tables.update(*scene));
    }
    CHECK(tables.revision() == rows);
    CHECK(tables.critical_images_made() == images);
    check_same_as_anew();
    scene->disc->inner += 0.5;
    REQUIRE(tables.update(*scene));
    CHECK(tables.revision() == rows);
    CHECK(tables.critical_images_made() == images + 1);
    check_same_as_anew();
    scene->camera.r += 1.0;
    REQUIRE(tables.update(*scene));
    CHECK(tables.revision() == rows + 1);
    CHECK(tables.critical_images_made() == images + 2);
    check_same_as_anew();
    scene->disc.reset();
    REQUIRE(tables.update(*scene));
    CHECK(tables.critical_images() == nullptr);
}
