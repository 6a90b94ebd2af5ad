// Discs that are warped or have gaps: their shape, and what the reference sees of it.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "reference/frame_tracer.h"
#include "reference/plane_ray.h"
#include "scene/disc_shape.h"

namespace {

using namespace nullscope;

constexpr double kWarpDegree = M_PI / 180;

double warp_apart(Vec3 a, Vec3 b) { return length(a - b); }

DiscSpec warped_disc() {
    DiscSpec disc;
    disc.inner = 3, disc.outer = 20;
    disc.warp = {{4, 7, 9, 16}, {5, 20, 40, 30}, {0, 30, 60, 20}, {3, 8, 10, 20}};
    return disc;
}

TEST_CASE("disc warp: rows are met, equal ones are a plane, the surface has no crease") {
    const DiscSpec disc = warped_disc();
    const DiscShape shape(disc, 0);
    for (std::size_t i = 0; i < disc.warp.radii.size(); ++i) {
        const DiscPlane row =
                            disc_plane({kWarpDegree * disc.warp.tilts_deg[i], kWarpDegree * disc.warp.nodes_deg[i]}, 0),
                        found = shape.plane(disc.warp.radii[i]);
        CHECK(warp_apart(found.normal, row.normal) < 1e-15);
        CHECK(warp_apart(found.x, row.x) < 1e-15);
        CHECK(warp_apart(found.y, row.y) < 1e-15);
    }
    CHECK(shape.normal(3) == shape.normal(4));
    CHECK(warp_apart(shape.normal(19), shape.normal(16)) < 1e-15);
    // Its slope is as large on both sides of a row.
    constexpr double kBeside = 1e-5;
    for (const double r : {4.0, 7.0, 9.0, 16.0}) {
        const Vec3 before = (shape.normal(r) - shape.normal(r * (1 - kBeside))) / kBeside,
                   after = (shape.normal(r * (1 + kBeside)) - shape.normal(r)) / kBeside;
        CHECK(warp_apart(before, after) < 1e-3);
    }
    CHECK(warp_apart(shape.normal(7.5), shape.normal(7)) > 0.05);
    DiscSpec flat = disc;
    flat.warp = {{4, 7, 16}, {50, 50, 50}, {35, 35, 35}, {}};
    const DiscPlane leaning = disc_plane({50 * kWarpDegree, 35 * kWarpDegree}, 0);
    for (const double r : {3.0, 5.0, 12.0, 30.0})
        CHECK(warp_apart(DiscShape(flat, 7).normal(r), leaning.normal) < 1e-15);
}

TEST_CASE("disc warp: it precesses as a body") {
    DiscSpec disc = warped_disc(), turned = disc;
    disc.lean = {0.5, 0.3, 0.02}, turned.lean = {0.5, 0.3 + 0.02 * 50, 0};
    for (double& node : turned.warp.nodes_deg) node += 0.02 * 50 / kWarpDegree;
    for (const double r : {3.0, 6.0, 12.0})
        CHECK(warp_apart(DiscShape(disc, 50).normal(r), DiscShape(turned, 0).normal(r)) < 1e-14);
}

TEST_CASE("disc warp: rings and their ends") {
    const DiscShape shape(warped_disc(), 0);
    for (const double r : {3.0, 5.0, 8.0, 10.0, 20.0}) CHECK(shape.within(r) >= 0);
    for (const double r : {2.9, 8.01, 9.0, 9.99, 21.0}) CHECK(shape.within(r) < 0);
    CHECK(shape.within(9.5) == doctest::Approx(-std::log(10 / 9.5)));
}

Scene warped_scene(double camera_r) {
    Scene scene;
    CameraSpec& camera = scene.camera;
    camera.width = 24, camera.height = 16, camera.plane_width = 1.2, camera.r = camera_r, camera.theta = 1.5;
    scene.disc = warped_disc();
    scene.disc->opacity = 0.5;
    return scene;
}

// On the ring of their radius, in the order of the ray, on no gap; and all of them: between two the ray is on one side.
TEST_CASE("disc warp: the reference's hits are on the disc, and none is left out") {
    constexpr int kPlaces = 4000;
    std::mt19937_64 dice(56);
    std::uniform_real_distribution<double> unit(0, 1);
    int hits = 0, several = 0;
    double most = 0;
    for (const double camera_r : {7.5, 30.0, 300.0}) {
        Scene scene = warped_scene(camera_r);
        scene.camera.plane_width = std::min(1.2, 40 / camera_r);
        const DiscShape shape(*scene.disc, 0);
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE(tracer);
        for (int i = 0; i < 40; ++i) {
            const auto ray = tracer->ray(24 * unit(dice), 16 * unit(dice));
            const reference::PlaneRay& plane = *ray->in_plane();
            const auto met = tracer->disc_hits(*ray, 16);
            hits += static_cast<int>(met.size()), several += met.size() > 2;
            for (const auto& hit : met) {
                const double r = plane.radius_at(hit.along);
                CHECK(shape.within(r) >= -1e-9);
                CHECK(std::hypot(hit.x, hit.y) == doctest::Approx(r).epsilon(1e-12));
                CHECK(warp_apart(shape.plane(r).place(hit.x, hit.y), plane.place_at(hit.along)) < 1e-9 * r);
                most = std::max(most, std::fabs(dot(shape.normal(r), plane.plane().direction(hit.along))));
            }
            int counted = 0;
            double last = 0;
            for (int k = 1; k < kPlaces; ++k) {
                const double angle = plane.end() * k / kPlaces, r = plane.radius_at(angle),
                             height = dot(shape.normal(r), plane.plane().direction(angle));
                if (last * height < 0 && shape.within(r) > 0.01) ++counted;
                last = height;
            }
            CHECK(counted <= static_cast<int>(met.size()));
        }
    }
    fmt::print("disc warp: {} hits of 120 rays, {} rays with more than two, heights over the disc {:.1e} at most\n",
               hits, several, most);
    CHECK(most < 1e-12);
    CHECK(hits > 60);
    CHECK(several > 3);
}

}  // namespace
