// The reference's images of a star behind a far hole against the lens in the weak field.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/frame_tracer.h"
#include "reference/star_images.h"
#include "support/far_star.h"

using namespace nullscope;
using namespace nullscope::test;

TEST_CASE("far star: the reference's images are as bright as the lens in the weak field has them") {
    // What the weak field leaves out is of second order in the Einstein angle (Keeton and Petters 2005): 2e-7 from 1e7
    // r_s. The Jacobian is differenced over 1e-3 px: 1e-15 of rounding over that, 1.1e-9 rad at 1e9 r_s, is 1e-6.
    constexpr double kTolerance = 2e-6;
    double worst = 0;
    for (const double r : {1e7, 1e8, 1e9})
        for (const double u : {0.1, 0.3, 1.0, 3.0}) {
            const Scene scene = far_star_scene(r, u, 1.0);
            const auto tracer = reference::FrameTracer::make(scene);
            REQUIRE(tracer);
            const PointStar star = (*point_stars(scene.sky, {}))[0];
            const double pixel = scene.camera.plane_width / scene.camera.width;
            double sum = 0;
            int count = 0;
            for (const auto& image : reference::StarImages(*tracer, scene, 2).of(star.direction, 0)) {
                const double x = (image.x - 160) * pixel, y = (image.y - 120) * pixel;
                sum += pixel * pixel / std::pow(1 + x * x + y * y, 1.5) / image.solid_angle;
                ++count;
            }
            CAPTURE(r);
            CAPTURE(u);
            CHECK(count == 2);
            const double error = std::fabs(sum / weak_magnification(u) - 1);
            CHECK(error < kTolerance);
            worst = std::max(worst, error);
        }
    fmt::print("far star: the reference's magnification is within {:.2g} of the weak field's\n", worst);
}
