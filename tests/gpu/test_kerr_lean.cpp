// Discs that lean about rotating holes, as the driver draws them: against the reference for random tilts, cameras and spins, ring by ring, and
// with their light.
#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "scene/leaning_disc.h"
#include "sky/sky.h"
#include "support/draft.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"
#include "support/places_off.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kLeanPlace_px = 0.02;  // of 1920 px of width
constexpr double kFallPlace_px = 0.05;  // seen from within the hole, where discs are near: some 5e-6 r_s

// part: how many of a picture's 1920 columns eight columns of this one are.
Scene lean_scene(std::mt19937& random, double part) {
    const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Draft draft;
    draft.metric("kerr-newman", {{"spin", among(-0.99, 0.99)}, {"charge", 0.0}}).by(ObserverKind::kZamo);
    draft.place(std::exp(among(1.6, 3.6)), std::acos(among(-0.99, 0.99))).size(8, 6);
    const double whole = among(0.4, 1.6);
    draft.plane(whole * part / 1920);
    draft.disc(among(1.2, 4), among(6, 25)).sky(SkyKind::kGrid);
    CameraSpec& camera = draft.scene.camera;
    camera.phi = among(-3, 3), camera.roll = among(-3, 3), camera.yaw = whole * among(-0.3, 0.3),
    camera.pitch = whole * among(-0.2, 0.2);
    draft.scene.disc->lean = {std::acos(among(-1, 1)), among(-3, 3), among(-0.1, 0.1)};
    draft.scene.time = among(-20, 20);
    return draft;
}

// Right above the disc its places are closer together from pixel to pixel than floats, 1e-6 r_s: not there.
void put_off_disc(Scene& scene) {
    constexpr double kAbove = 0.1;
    CameraSpec& camera = scene.camera;
    const double height = dot(disc_plane_of(scene).normal, world_from_static(camera.theta, camera.phi).a);
    if (std::fabs(height) < kAbove) camera.r = std::max(camera.r, 1.3 * scene.disc->outer);
}

TEST_CASE("kerr lean: places of random tilts and cameras are the reference's" * costly()) {
    on_one_context([](GpuSession& session) {
        const int views = by_depth(60, 300, 300);
        std::mt19937 random(55);
        PlacesOff off;
        for (int view = 0; view < views; ++view) {
            Scene scene = lean_scene(random, 8);
            put_off_disc(scene);
            CAPTURE(view);
            off.add(session, scene, kLeanPlace_px);
        }
        off.check("kerr lean", 10 * views);
    });
}

// A camera that falls, from outside to between the horizons.
TEST_CASE("kerr lean: places seen by cameras that fall are the reference's") {
    on_one_context([](GpuSession& session) {
        const int views = by_depth(24, 200, 200);
        std::mt19937 random(58);
        const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        PlacesOff off;
        for (int view = 0; view < views; ++view) {
            Scene scene = lean_scene(random, 8);
            CameraSpec& camera = scene.camera;
            double& spin = scene.spacetime.parameters["spin"];
            if (view % 4 == 0)
                spin = std::copysign(among(0.9, 0.99), spin);  // light comes out late on its ingoing azimuth
            const double half = 0.5 * std::sqrt((1 - spin) * (1 + spin));
            camera.observer = view % 3 == 2 ? ObserverKind::kThrow : ObserverKind::kRain, camera.energy = 1.3;
            camera.r = view % 2 == 0 ? 0.5 + half * among(-0.8, 0.9) : std::exp(among(0.1, 2));
            camera.yaw = among(-3, 3), camera.pitch = among(-1, 1);
            scene.disc->inner = (0.5 + half) * among(1.05, 2);
            CAPTURE(view);
            off.add(session, scene, kFallPlace_px);
        }
        off.check("kerr lean, cameras that fall", 10 * views);
    });
}

// The first crossing from number passed on, counted from 0, that is within the disc; 0 0 0: none.
Vec3 met_by_reference(const reference::FrameTracer& tracer, const Scene& scene, double x, double y, int passed) {
    const auto ray = tracer.ray(x, y);
    const DiscPlane plane = disc_plane_of(scene);
    int number = 0;
    for (const auto& c : ray->crossings(16))
        if (number++ >= passed && c.r >= scene.disc->inner && c.r <= scene.disc->outer)
            return plane.place(c.r * std::cos(c.bearing), c.r * std::sin(c.bearing));
    return {};
}

// Light's n-th image is what is seen where its first n crossings do not count. Pixels may differ only where a rim is near.
// Some of these rays cross the plane twice within a step: the camera is a little above it.
TEST_CASE("kerr lean: rays along the plane that are dragged through it and back") {
    constexpr double kAlong_px = 1e-3, kAtOnce = 0.5;  // rad of the disc between two crossings
    on_one_context([=](GpuSession& session) {
        std::mt19937 random(90);
        double most_px = 0;
        int twice = 0;
        const int views = by_depth(3, 20, 20);
        for (int view = 0; view < views; ++view) {
            const auto among = [&](double low, double high) {
                return std::uniform_real_distribution(low, high)(random);
            };
            Draft draft;
            draft.metric("kerr", {{"spin", among(0.8, 0.95)}})
                .by(ObserverKind::kZamo)
                .place(15.6, 3.039)
                .plane(0.3)
                .size(24, 18);
            draft.disc(1.77, 12).yaw(0.12);
            draft.scene.camera.phi = 1.054 + among(-0.05, 0.05);
            draft.scene.disc->lean = {1.642 + among(-0.01, 0.01), -0.641};
            const Scene scene = draft;
            CAPTURE(view);
            const RayMeasures m =
                measure_rays(gl_ray_data(session, scene), scene.camera, remembered(reference_trace(scene)));
            most_px = std::max(most_px, m.place_px.max);
            CHECK(m.fate_errors == 0);
            const auto tracer = reference::FrameTracer::make(scene);
            REQUIRE(tracer);
            for (int y = 0; y < 18; ++y)
                for (int x = 0; x < 24; ++x) {
                    const auto hits = tracer->disc_hits(*tracer->ray(x + 0.5, y + 0.5), 2);
                    if (hits.size() < 2) continue;
                    const auto &a = hits[0], &b = hits[1];
                    twice += std::fabs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)) < kAtOnce;
                }
        }
        fmt::print(
            "kerr lean: {} views along the plane: {:.1e} px at most, {} rays cross it twice within half a radian\n",
            views, most_px, twice);
        CHECK(most_px < kAlong_px);
        CHECK(twice > views);
    });
}

// How far the camera has to turn left for the shadow's edge, rad.
double yaw_of_edge(Scene scene) {
    double in = 0, out = -0.5;
    for (int i = 0; i < 40; ++i) {
        scene.camera.yaw = 0.5 * (in + out);
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE(tracer);
        const auto ray = tracer->ray(0.5 * scene.camera.width, 0.5 * scene.camera.height);
        (ray->fate() == Fate::kCaptured ? in : out) = scene.camera.yaw;
    }
    return 0.5 * (in + out);
}

TEST_CASE("kerr lean: images n = 1 and 2 have the reference's places, with no gaps" * costly()) {
    constexpr double kBeside_px = 0.05, kRing_px = 0.05;
    on_one_context([=](GpuSession& session) {
        Selection selection(3);
        for (const double tilt_deg : {25.0, 65.0, 115.0}) {
            if (!selection.takes_next()) continue;
            for (const int passed : {1, 2}) {
                Draft draft;
                draft.metric("kerr", {{"spin", 0.9}}).by(ObserverKind::kZamo).place(12, 1.2).size(32, 32);
                // The ring's left side: n = 2 is exp(-pi) of n = 1.
                draft.plane(passed == 1 ? 0.55 : 0.005).disc(2, 12);
                if (passed == 2) draft.yaw(yaw_of_edge(draft));
                draft.scene.disc->lean = {tilt_deg * M_PI / 180, 0.6};
                const Scene scene = draft;
                session.renderer->pass_crossings(passed);
                const RayFrame drawn = gl_ray_data(session, scene);
                session.renderer->pass_crossings(0);
                const auto tracer = reference::FrameTracer::make(scene);
                REQUIRE(tracer);
                int met = 0, missed = 0, at_rims = 0;
                double most = 0;
                for (int y = 0; y < drawn.height; ++y)
                    for (int x = 0; x < drawn.width; ++x) {
                        const RayPixel& pixel = drawn.at(x, y);
                        const auto there = [&](double dx, double dy) {
                            return met_by_reference(*tracer, scene, x + 0.5 + dx, y + 0.5 + dy, passed);
                        };
                        const Vec3 exact = there(0, 0);
                        const bool on = !(exact == Vec3{});
                        if (!on && pixel.hit != kDiscHit) continue;
                        const Vec3 right = there(kBeside_px, 0), left = there(-kBeside_px, 0),
                                   up = there(0, kBeside_px), down = there(0, -kBeside_px);
                        int beside = 0;
                        for (const Vec3& v : {right, left, up, down}) beside += !(v == Vec3{});
                        if (beside != (on ? 4 : 0)) {
                            ++at_rims;
                            continue;
                        }
                        missed += on != (pixel.hit == kDiscHit);
                        if (!on || pixel.hit != kDiscHit) continue;
                        ++met;
                        const double moves = std::max({length(right - exact), length(left - exact), length(up - exact),
                                                       length(down - exact)}) /
                                             kBeside_px;
                        most = std::max(most, length(Vec3{pixel.u, pixel.v, pixel.w} - exact) / moves);
                    }
                fmt::print(
                    "kerr lean: tilt {}, image {}: {} pixels within {:.1e} px, {} missed or too many, {} at rims\n",
                    tilt_deg, passed, met, most, missed, at_rims);
                CHECK(met > 40);
                CHECK(missed == 0);
                CHECK(most < kRing_px);
            }
        }
    });
}

// How far a drawn place is off: px across the ring, where places move fast from pixel to pixel, and r_s along it.
struct ZoomOff {
    double across_px = 0, along = 0;
    int places = 0, wrong_hits = 0, late = 0;
    void add(const reference::FrameTracer& tracer, double x, double y, const RayPixel& drawn) {
        constexpr double kBeside_px = 0.01;
        constexpr std::size_t kLate = 4;  // crossings before the disc is met
        const auto place = [&](double right, double down) {
            const RayPixel pixel = tracer.pixel(x + right, y + down, false);
            return Vec3{pixel.u, pixel.v, pixel.w};
        };
        const RayPixel exact = tracer.pixel(x, y, false);
        wrong_hits += exact.hit != drawn.hit || exact.fate != drawn.fate;
        if (exact.hit != kDiscHit || drawn.hit != kDiscHit) return;
        const Vec3 at = place(0, 0), right = (place(kBeside_px, 0) - at) / kBeside_px,
                   down = (place(0, kBeside_px) - at) / kBeside_px, off = Vec3{drawn.u, drawn.v, drawn.w} - at,
                   moves = length(right) > length(down) ? right : down;
        const double across = dot(off, moves) / std::max(dot(moves, moves), 1e-6);
        across_px = std::max(across_px, std::fabs(across)), along = std::max(along, length(off - across * moves));
        ++places;
        const auto ray = tracer.ray(x, y);
        std::size_t number = 0;
        for (const auto& c : ray->crossings(16)) number += c.along < tracer.disc_hits(*ray, 1).front().along;
        late += number > kLate;
    }
};

// Into the photon ring, whose light has gone round several times that the picture leaves out before it meets a narrow disc.
TEST_CASE("kerr lean: zooms into the photon ring have the reference's places") {
    constexpr double kAcross_px = 1e-3, kAlong = 1e-3;  // r_s, of places that move by up to 300 r_s a pixel
    on_one_context([=](GpuSession& session) {
        std::mt19937 random(59);
        const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        ZoomOff off;
        const int views = by_depth(12, 60, 60);
        for (int view = 0; view < views; ++view) {
            Draft draft;
            draft.metric("kerr", {{"spin", among(-0.95, 0.95)}}).by(ObserverKind::kZamo).place(14, among(0.4, 2.7));
            draft.size(10, 8).disc(among(2.2, 2.5), among(2.8, 3.4)).sky(SkyKind::kGrid);
            draft.scene.disc->lean = {among(0.3, 2.8), among(-3, 3)};
            draft.scene.camera.zoom = ZoomSpec{among(19, 23), among(-3, 3)};
            const Scene scene = draft;
            const RayFrame drawn = gl_ray_data(session, scene);
            const auto tracer = reference::FrameTracer::make(scene);
            REQUIRE(tracer);
            for (int y = 0; y < drawn.height; ++y)
                for (int x = 0; x < drawn.width; ++x) off.add(*tracer, x + 0.5, y + 0.5, drawn.at(x, y));
        }
        fmt::print(
            "kerr lean: {} zooms, {} places, {} after more than 4 crossings: {:.1e} px across the ring, {:.1e} r_s "
            "along it; fates or hits differ in {} rays\n",
            views, off.places, off.late, off.across_px, off.along, off.wrong_hits);
        CHECK(off.across_px < kAcross_px);
        CHECK(off.along < kAlong);
        CHECK(off.wrong_hits == 0);
        CHECK(off.late > views);
    });
}

// Heat, shift by matter about an axis that leans, spots and flow, seen late.
TEST_CASE("kerr lean: pictures have the reference's light" * costly()) {
    on_one_context([](GpuSession& session) {
        for (const bool spots : {false, true}) {
            Draft draft;
            draft.metric("kerr", {{"spin", 0.8}}).by(ObserverKind::kZamo).place(15, 1.1).plane(1.1).size(18, 12);
            draft.disc(3, 11).sky(SkyKind::kBlack).at_time(12);
            DiscSpec& disc = *draft.scene.disc;
            disc.lean = {0.9, 0.5}, disc.emission = DiscEmission::kThermal;
            if (spots) draft.scene.spots.push_back({.r = 5, .phase = 1, .size = 0.8, .brightness = 2, .count = 3});
            const Scene scene = draft;
            const auto sky = build_sky(scene.sky, {}, 16);
            REQUIRE(sky);
            const auto light_of = [&](const Scene& of) {
                auto exact = reference::render_frame(of, *sky, nullptr, 4, {});
                REQUIRE(exact);
                return std::move(*exact);
            };
            const Image<float> drawn = picture_of(session, scene), exact = light_of(scene);
            Scene other = scene;
            other.spacetime.parameters["spin"] = -0.8;
            const Image<float> wrong = light_of(other);
            fmt::print("kerr lean: {} differ by {:.4f} of the light, those of the other spin by {:.3f}\n",
                       spots ? "spots" : "heat", light_off(drawn, exact), light_off(drawn, wrong));
            CHECK(light_off(drawn, exact) < 0.03);  // of rims, which the reference's 4 by 4 rays have in sixteenths
            CHECK(light_off(drawn, wrong) > 0.05);
        }
    });
}

}  // namespace
