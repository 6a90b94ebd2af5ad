// Every pixel of many small frames against the reference: objects, fast cameras, and places where formulas degenerate.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kScreenError_px = 0.05;  // sky direction, swept angle, g: the project's promise
constexpr double kPlaceError_px = 0.05;   // of the first hit
// What a direction or a frequency stored as float can be off by, rad or relative: two roundings. Beyond a zoom of 4e-6 rad a
// pixel it is more than the promise, however exact the ray.
constexpr double kStored = 2 * 1.2e-7;


struct Case {
    const char* name;
    std::function<void(Scene&)> set;
};

Scene odd_scene() {  // the middle pixel looks exactly along the axis
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.width = 321;
    scene.camera.height = 181;
    return scene;
}

void with_disc(Scene& s, double opacity) {
    s.camera.r = 20;
    s.disc = DiscSpec{};
    s.disc->opacity = opacity;
}

void narrow(Scene& s, double fov_rad) { s.camera.plane_width = 2 * std::tan(0.5 * fov_rad); }

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"flat", [](Scene& s) { s.spacetime.metric = "minkowski"; }},
        {"flat, disc", [](Scene& s) { with_disc(s, 1), s.spacetime.metric = "minkowski", s.camera.theta = 1.2; }},
        {"flat, moving at 0.86 c",
         [](Scene& s) {
             s.spacetime.metric = "minkowski", s.camera.velocity = {-0.5, 0.1, 0.69};
         }},
        {"default", [](Scene&) {}},
        {"opaque disc", [](Scene& s) { with_disc(s, 1); }},
        {"opaque disc from 68 degrees", [](Scene& s) { with_disc(s, 1), s.camera.theta = 68 * M_PI / 180; }},
        {"translucent disc", [](Scene& s) { with_disc(s, 0.6); }},
        {"disc, camera below it", [](Scene& s) { with_disc(s, 1), s.camera.theta = M_PI - 1.3; }},
        {"disc, camera between its rims, above",
         [](Scene& s) { with_disc(s, 1), s.camera.r = 7, s.camera.theta = 1.4; }},
        {"disc, camera in its plane", [](Scene& s) { with_disc(s, 1), s.camera.theta = M_PI / 2; }},
        {"disc, camera near its plane", [](Scene& s) { with_disc(s, 1), s.camera.theta = M_PI / 2 - 1e-4; }},
        {"disc inside the photon sphere",
         [](Scene& s) { with_disc(s, 1), s.disc->inner = 1.05, s.disc->outer = 1.45; }},
        {"disc, moving at 0.86 c",
         [](Scene& s) {
             with_disc(s, 1), s.camera.r = 12, s.camera.theta = 1.3, s.camera.velocity = {-0.5, 0, 0.7};
         }},
        {"moving at 0.86 c, inwards",
         [](Scene& s) {
             s.camera.velocity = {-0.86, 0, 0};
         }},
        {"moving at 0.86 c, looking back",
         [](Scene& s) {
             s.camera.velocity = {-0.86, 0, 0}, s.camera.yaw = M_PI;
         }},
        {"moving at 0.999999 c, inwards",
         [](Scene& s) {
             s.camera.velocity = {-0.999999, 0, 0};
         }},
        {"moving at 0.999999 c, across",
         [](Scene& s) {
             s.camera.velocity = {0, 0, 0.999999};
         }},
        {"moving at 0.999999 c, outwards",
         [](Scene& s) {
             s.camera.velocity = {0.999999, 0, 0};
         }},
        {"on the polar axis", [](Scene& s) { with_disc(s, 1), s.camera.theta = 0; }},
        {"on the other polar axis", [](Scene& s) { with_disc(s, 0.5), s.camera.theta = M_PI; }},
        {"at the photon sphere", [](Scene& s) { s.camera.r = 1.5, s.camera.plane_width = 3; }},
        {"at the photon sphere, across", [](Scene& s) { s.camera.r = 1.5, s.camera.yaw = M_PI / 2; }},
        {"just outside the photon sphere", [](Scene& s) { s.camera.r = 1.5 + 1e-9, s.camera.yaw = M_PI / 2; }},
        {"just inside the photon sphere", [](Scene& s) { s.camera.r = 1.5 - 1e-9, s.camera.yaw = M_PI / 2; }},
        {"at r = 1.0001, outwards", [](Scene& s) { s.camera.r = 1.0001, s.camera.yaw = M_PI; }},
        {"at r = 1.0001, inwards", [](Scene& s) { s.camera.r = 1.0001; }},
        {"at r = 1.0001, the cone of sky", [](Scene& s) { s.camera.r = 1.0001, s.camera.yaw = M_PI, narrow(s, 0.1); }},
        {"at r = 1e6", [](Scene& s) { s.camera.r = 1e6; }},
        {"at r = 1e6, the hole fills the frame", [](Scene& s) { s.camera.r = 1e6, narrow(s, 1.2e-5); }},
        {"at r = 1e4, disc", [](Scene& s) { with_disc(s, 1), s.camera.r = 1e4, s.camera.theta = 1.2, narrow(s, 4e-3); }},
        {"turned, rolled, pitched",
         [](Scene& s) {
             with_disc(s, 1), s.camera.theta = 1.2, s.camera.yaw = 0.3, s.camera.pitch = -0.2, s.camera.roll = 2;
         }},
        {"1x1", [](Scene& s) { s.camera.width = s.camera.height = 1; }},
        {"1x1, outwards", [](Scene& s) { s.camera.width = s.camera.height = 1, s.camera.yaw = M_PI; }},
        {"1x1, disc in its plane",
         [](Scene& s) { with_disc(s, 1), s.camera.theta = M_PI / 2, s.camera.width = s.camera.height = 1; }},
        {"1x257",
         [](Scene& s) {
             with_disc(s, 1), s.camera.width = 1, s.camera.height = 257, s.camera.plane_width = 1.2 / 257;
         }},
        {"257x1", [](Scene& s) { with_disc(s, 1), s.camera.width = 257, s.camera.height = 1; }},
    };
    return all;
}

bool whole(const RayFrame& frame) {  // every channel finite, every fate one that there is, directions of length 1
    constexpr double kUnit = 1e-5;   // a float normalisation, with room
    for (const RayPixel& p : frame.pixels) {
        if (!all_finite(p)) return false;
        if (p.fate != Fate::kEscaped && p.fate != Fate::kCaptured && p.fate != Fate::kOtherSide && p.fate != Fate::kHit) return false;
        const bool on_a_sky = p.fate == Fate::kEscaped || p.fate == Fate::kOtherSide;
        if (std::abs(length(p.sky) - (on_a_sky ? 1.0 : 0.0)) > kUnit) return false;
    }
    return true;
}

TEST_CASE("scenes: fates, hits, angles and directions are the reference's at every pixel") {
    on_every_context([](GpuSession& session) {
        for (const Case& c : cases()) {
            const std::string name = c.name;
            CAPTURE(name);
            Scene scene = odd_scene();
            c.set(scene);
            const RayFrame frame = gl_ray_data(session, scene);
            CHECK(whole(frame));
            const RayMeasures m = measure_rays(frame, scene.camera, reference_trace(scene));
            fmt::print(
                "{:<7} {:<38} screen {:.1e}, place {:.1e}, swept {:.1e}, g {:.1e} px; fate errors {}, forgiven {}\n",
                session.context->kind(), c.name, m.sky_px.max, m.place_px.max, m.angle_px.max, m.g_px.max,
                m.fate_errors, m.forgiven);
            const double stored_px = kStored / pixel_angle(scene.camera, 0, 0);
            CHECK(m.fate_errors == 0);
            CHECK(m.sky_px.max <= std::max(kScreenError_px, stored_px));
            CHECK(m.angle_px.max <= std::max(kScreenError_px, M_PI * stored_px));  // angles are of order pi
            CHECK(m.g_px.max <= std::max(kScreenError_px, stored_px));
            CHECK(m.place_px.max <= kPlaceError_px);
        }
    });
}

}  // namespace
