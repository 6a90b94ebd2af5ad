// The light of a star behind a hole, from 1e2 to 1e9 r_s away from it, against the reference's sum over both images.
#include <algorithm>
#include <cmath>

#include "reference/frame_tracer.h"
#include "reference/star_images.h"
#include "support/far_star.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Green light in the square of pixels about a place.
double light_about(const Image<float>& picture, double x, double y) {
    constexpr int kReach = 5;  // px: 7 sigma of the point spread
    double sum = 0;
    for (int row = static_cast<int>(y) - kReach; row <= static_cast<int>(y) + kReach; ++row)
        for (int column = static_cast<int>(x) - kReach; column <= static_cast<int>(x) + kReach; ++column)
            sum += picture.at(column, row)[1];
    return sum;
}

TEST_CASE("far star: both images are as bright as the reference has them, from 1e2 to 1e9 r_s") {
    constexpr double kTolerance = 0.01;  // what the project promises; reached: see the line printed
    constexpr double kLight = 2000;      // half floats end at 65504; the magnitude_limit image has 17
    on_every_context([&](GpuSession& session) {
        double worst_sum = 0, worst_image = 0;
        for (double r = 1e2; r < 2e9; r *= 10)
            for (const double u : {0.3, 1.0, 3.0}) {
                CAPTURE(r);
                CAPTURE(u);
                const Scene scene = far_star_scene(r, u, kLight);
                const Image<float> picture = picture_of(session, scene);
                const auto tracer = reference::FrameTracer::make(scene);
                REQUIRE(tracer);
                const PointStar star = (*point_stars(scene.sky, {}))[0];
                double drawn = 0, exact = 0;
                int count = 0;
                for (const auto& image : reference::StarImages(*tracer, scene, 2).of(star.direction, 0)) {
                    const double found = light_about(picture, image.x, image.y);
                    const double expected = reference::star_light(star, image.g, scene.light).y / image.solid_angle;
                    drawn += found, exact += expected;
                    worst_image = std::max(worst_image, std::fabs(found / expected - 1));
                    ++count;
                }
                CHECK(count == 2);
                CHECK(std::fabs(drawn / exact - 1) <= kTolerance);
                worst_sum = std::max(worst_sum, std::fabs(drawn / exact - 1));
            }
        CHECK(worst_image <= kTolerance);
        fmt::print("far star: light of both images within {:.2g} of the reference's, of each within {:.2g}\n",
                   worst_sum, worst_image);
    });
}

}  // namespace
