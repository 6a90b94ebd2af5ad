// Views next to the critical curve of a rotating hole: narrow ones by every observer, and zooms into its photon ring. Rays against the reference.
//
// Across the curve light's end moves by up to millions of radians a pixel: there errors are in pixels. Along it the end hardly moves, and
// a pixel may be narrower than what a float direction holds: there errors are in radians of where the light ends.
#include <algorithm>
#include <cmath>
#include <random>

#include "observer/critical_light.h"
#include "observer/pose.h"
#include "observer/ring_view.h"
#include "observer/spin_ring.h"
#include "spacetime/registry.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kDegree = M_PI / 180;
constexpr double kDeepestAlong = 19;  // depth: further in the reference's own rounding shows along the curve
constexpr double kEdge_px = 0.01;     // of the critical curve: closer to it fates may differ

struct KerrRingViewsOff {
    double across_px = 0, along = 0;
    int fates = 0, rays = 0;
    void add(const KerrRingViewsOff& other) {
        across_px = std::max(across_px, other.across_px), along = std::max(along, other.along);
        fates += other.fates, rays += other.rays;
    }
};

KerrRingViewsOff off_of(const Scene& scene, const RayFrame& frame, int row_step) {
    const auto spacetime = *make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const CameraSpec camera = *without_zoom(*spacetime, scene.camera, scene.light);
    CameraSpec middle = camera;     // the critical curve is nearly straight in all views here
    constexpr double kPart = 0.01;  // of a pixel
    middle.width = middle.height = 2, middle.plane_width *= kPart * 2.0 / camera.width;
    const auto form = peak_form(*spacetime->axial(), middle, *observer_of(*spacetime, camera), scene.light);
    REQUIRE(form);
    const auto& c = form->c;
    const double slope = std::hypot(c[1], c[2]);
    const Vec3 across{c[1] / slope, -c[2] / slope, 0};  // in the picture, y down
    const ExactTrace trace = reference_trace(scene);
    KerrRingViewsOff off;
    for (int row = row_step / 2; row < frame.height; row += row_step)
        for (int column = 0; column < frame.width; ++column) {
            const double x = column + 0.5, y = row + 0.5, right = x - 0.5 * frame.width, up = 0.5 * frame.height - y;
            const double distance = std::fabs(kPart * c[0] + c[1] * right + c[2] * up) / slope;  // px
            const auto moved = [&](double by) -> std::array<double, 2> {
                return {x + by * across.x, y + by * across.y};
            };
            const RayPixel& got = frame.at(column, row);
            if (distance < kEdge_px) continue;
            const double step = std::min(0.01, 1e-3 * distance);
            double by = 0;
            Vec3 left;
            for (int k = 0; k < 2; ++k) {
                const auto exact = trace({moved(by), moved(by + step)});
                if (k == 0) off.fates += got.fate != exact[0].fate;
                if (got.fate != Fate::kEscaped || exact[0].fate != got.fate || exact[1].fate != got.fate) break;
                left = got.sky - exact[0].sky;
                const Vec3 moves = (exact[1].sky - exact[0].sky) / step;
                const double more = dot(left, moves) / std::max(dot(moves, moves), 1e-300);
                by += more, left = left - more * moves;
                ++off.rays;
            }
            off.across_px = std::max(off.across_px, std::fabs(by)), off.along = std::max(off.along, length(left));
        }
    return off;
}

std::string words(const Scene& scene, const KerrRingViewsOff& off) {
    const CameraSpec& c = scene.camera;
    return fmt::format(
        "{:<13} a {:.4f} r {:7.3f} theta {:.2f} v {:.2f} pixel {:.1e} rad: {:.4f} px across, {:.1e} rad along; fates "
        "{}",
        observer_name(c.observer), scene.spacetime.parameters.at("spin"), c.r, c.theta, length(c.velocity), c.pixel(),
        off.across_px, off.along, off.fates);
}

struct Most {
    KerrRingViewsOff promised, hard;
    int views = 0, hard_views = 0;
    void add(const Scene& scene, KerrRingViewsOff off) {
        const auto spacetime = *make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        const bool is_hard = is_hard_ring(*spacetime, scene.camera.r);
        if (scene.camera.zoom && scene.camera.zoom->depth > kDeepestAlong) off.along = 0;
        if (!is_hard && (off.across_px > kRingAcross_px || off.along > kRingAlong || off.fates > 0))
            fmt::print("{}\n", words(scene, off));
        ++(is_hard ? hard_views : views);
        (is_hard ? hard : promised).add(off);
    }
    void check() const {
        fmt::print("{} views, {} rays: {:.4f} px across the critical curve, {:.1e} rad along it, fate errors {}\n",
                   views, promised.rays, promised.across_px, promised.along, promised.fates);
        fmt::print("{} views at spin > {} or nearer to the horizon than {}: {:.4f} px, {:.1e} rad, fate errors {}\n",
                   hard_views, kRingFastest, kRingNearest, hard.across_px, hard.along, hard.fates);
        CHECK(promised.across_px <= kRingAcross_px);
        CHECK(promised.along <= kRingAlong);
        CHECK(promised.fates == 0);
        CHECK(hard.across_px <= kRingHardest_px);
    }
};

// The next of a sequence of cameras about rotating holes, and the light of a point of the critical curve.
struct Aimed {
    Scene scene;
    Vec3 light;
};
Aimed next_aimed(std::mt19937_64& random) {
    const auto from = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto log_from = [&](double low, double high) { return std::exp(from(std::log(low), std::log(high))); };
    for (;;) {
        Scene scene;
        scene.sky.kind = SkyKind::kGrid;
        scene.spacetime = {"kerr", {{"spin", 1 - log_from(1e-4, 0.85)}}};
        const auto spacetime = *make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        using enum ObserverKind;
        const ObserverKind kinds[] = {kStatic, kZamo, kCarter, kOrbit, kCounterOrbit, kThrow, kRain};
        CameraSpec& camera = scene.camera;
        camera.observer = kinds[random() % std::size(kinds)];
        camera.r = *spacetime->horizon_radius() + log_from(0.05, 50);
        camera.theta = from(0.01, M_PI - 0.01), camera.phi = from(0, 6), camera.energy = log_from(1, 3);
        if (random() % 2 == 0) camera.velocity = {from(-0.5, 0.5), from(-0.5, 0.5), from(-0.5, 0.5)};
        camera.width = 96, camera.height = 54;
        const auto light = CriticalLight::make(*spacetime, camera, scene.light);
        const double angle = from(0, 2 * M_PI);
        if (light) return {scene, light->direction(angle)};
    }
}

TEST_CASE("kerr ring: narrow views next to the shadow, by every observer, down to 1e-4 degrees" * test::costly()) {
    std::mt19937_64 random(24);
    auto session = open_gpu("egl");
    REQUIRE(session);
    const int count = by_depth(6, 300, 300), row_step = by_depth(18, 27, 18);
    Most most;
    for (int i = 0; i < count; ++i) {
        auto [scene, light] = next_aimed(random);
        CameraSpec& camera = scene.camera;
        const auto from = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        camera.plane_width = 2 * std::tan(0.5 * kDegree * std::exp(from(std::log(1e-4), std::log(1.0))));
        set_direction(camera, -(static_from_camera(CameraSpec{}) * light));
        camera.yaw += camera.plane_width * from(-0.3, 0.3), camera.pitch += camera.plane_width * from(-0.15, 0.15);
        most.add(scene, off_of(scene, gl_ray_data(*session, scene), row_step));
    }
    most.check();
}

TEST_CASE("kerr ring: zooms are the reference's as deep as its digits go" * test::costly()) {
    std::mt19937_64 random(25);
    auto session = open_gpu("egl");
    REQUIRE(session);
    Most most;
    Selection selection(2);
    for (int i = 0; i < by_depth(3, 20, 40); ++i) {
        auto [scene, light] = next_aimed(random);
        scene.camera.plane_width = 0.1;
        scene.camera.zoom.emplace().angle = std::uniform_real_distribution(0.0, 2 * M_PI)(random);
        const auto spacetime = *make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        if (!ring_view(*spacetime, scene.camera, scene.light)) continue;  // images that shrink too little each
        for (const double depth : {0.0, 4.0, 9.0, 14.0, 18.0, 20.0}) {
            if (!selection.takes_next()) continue;
            scene.camera.zoom->depth = depth;
            most.add(scene, off_of(scene, gl_ray_data(*session, scene), 18));
        }
    }
    most.check();
    CHECK(most.views > by_depth(6, 60, 120));
}

}  // namespace
