// The cells of a star's surface, where they are narrow.
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

TEST_CASE("star surface: its cells go on to the pole, as far as a pixel tells them apart") {
    constexpr PictureBound kMost{1e-3, 1e-3, 0.26};  // the edge of two columns is in two pixels of eight of each line
    on_every_context([&](GpuSession& session) {
        // Of a camera straight above a place that is so far from the pole.
        for (const auto& [theta, fov] : {std::pair{0.02, 6.6e-5}, {0.02, 6.6e-4}, {0.3, 1e-3}, {5.0, 1e-2}}) {
            Scene scene = bare_scene("neutron-star", 0);
            scene.camera.theta = theta * M_PI / 180;
            scene.camera.plane_width = 2 * std::tan(0.5 * fov * M_PI / 180);
            scene.camera.width = 8, scene.camera.height = 4;
            held(session, fmt::format("star {} degrees from the pole, field of {} degrees", theta, fov), scene, kMost);
        }
    });
}

}  // namespace
