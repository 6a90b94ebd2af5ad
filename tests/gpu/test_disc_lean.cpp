// Discs that lean, as the driver draws them: against the reference, and against what a turned camera sees of one that does not.
#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "against_reference.h"
#include "observer/pose.h"
#include "scene/leaning_disc.h"
#include "support/picture_off.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kOneDegree = M_PI / 180;

Draft leaning(Draft draft, double tilt_deg, double node_deg) {
    draft.disc(3, 12);
    draft.scene.disc->lean = {tilt_deg * kOneDegree, node_deg * kOneDegree};
    draft.scene.sky.kind = SkyKind::kGrid;
    return draft.plane(1.6).size(24, 14);
}

TEST_CASE("disc lean: frames are the reference's where rays stay in planes") {
    std::vector<FrameCase> cases;
    const auto add = [&](const std::string& name, const Draft& draft) { cases.push_back({name, draft}); };
    add("tilt 30", leaning(Draft{}.place(12, 1.2), 30, 40));
    add("tilt 90 on the axis", leaning(Draft{}.place(12, 0.0), 90, -70));
    add("tilt 160 from within", leaning(Draft{}.place(5, 1.5), 160, 10));
    add("moving", leaning(Draft{}.place(9, 0.7).moving({0.2, 0.3, -0.1}), 60, 130));
    add("rain inside", leaning(Draft{}.place(0.7, 1.3).by(ObserverKind::kRain), 45, 80));
    add("charged", leaning(Draft{}.metric("reissner-nordstrom", {{"charge", 0.9}}).place(8, 2.0), 75, 200));
    add("flat", leaning(Draft{}.metric("minkowski").place(10, 1.0), 75, 20));
    Draft edge_on = leaning(Draft{}.place(12, M_PI / 2 - 0.5), 0.5 / kOneDegree, -90);  // the camera is in its plane
    add("in the plane", edge_on);
    AgainstReference judge("disc lean", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920});
    on_one_context([&](GpuSession& session) { judge.frames(session, Selection(3), cases); });
}

CameraSpec turned(CameraSpec camera, const DiscPlane& plane) {
    const Mat3 disc_from_world = transposed({plane.x, plane.y, plane.normal}), axes = world_from_camera(camera);
    const Vec3 place = disc_from_world * world_from_static(camera.theta, camera.phi).a;
    camera.theta = std::atan2(std::hypot(place.x, place.y), place.z), camera.phi = std::atan2(place.y, place.x);
    set_world_axes(camera, disc_from_world * axes);
    return camera;
}

// All of a disc's light: what moves in it, late light, shifts, rings thinner than a pixel, and tiles with and without it.
TEST_CASE("disc lean: the picture is what a turned camera sees, rings, tiles and spots too") {
    on_one_context([](GpuSession& session) {
        for (const bool gas : {false, true}) {
            Draft one = leaning(Draft{}.place(15, 1.2), 50, 35);
            one.scene.sky.kind = SkyKind::kBlack, one.scene.camera.plane_width = 1.0;
            one.size(160, 96).at_time(30);
            DiscSpec& disc = *one.scene.disc;
            disc.emission = DiscEmission::kThermal;
            if (gas) disc.material.texture = TextureKind::kGas, disc.flow = DiscFlowKind::kKepler, disc.opacity = 0.8;
            if (!gas) one.scene.spots.push_back({.r = 5, .phase = 1, .size = 0.6, .count = 2});
            Draft other = one;
            other.scene.camera = turned(one.scene.camera, disc_plane_of(one.scene)), other.scene.disc->lean = {};
            Draft wrong = one;
            wrong.scene.disc->lean.node += 1 * kOneDegree;
            const Image<float> a = picture_of(session, one), b = picture_of(session, other),
                               c = picture_of(session, wrong);
            fmt::print("disc lean: {} as a turned camera sees it but for {:.1e} of its light; a degree beside {:.1e}\n",
                       gas ? "gas" : "spots", light_off(a, b), light_off(a, c));
            CHECK(light_off(a, b) < 1e-3);
            CHECK(light_off(a, c) > 0.01);
        }
    });
}

}  // namespace
