// Eyes of stereo pictures: where they are, which way they look, and where things are seen by them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/eye.h"
#include "observer/pose.h"
#include "scene/projection.h"
#include "scene/stereo.h"
#include "spacetime/registry.h"

using namespace nullscope;

namespace {

constexpr double kEyePi = std::numbers::pi;
constexpr double kEyeRounding = 1e-9;  // measured: 2e-11

std::shared_ptr<const Spacetime> world(const std::string& metric,
                                       const std::vector<std::pair<std::string, double>>& parameters = {}) {
    MetricParameters all;
    for (const auto& [name, value] : parameters) all[name] = value;
    auto made = make_spacetime(metric, all);
    REQUIRE(made);
    return *made;
}

Eye eye_of(const Spacetime& spacetime, const CameraSpec& camera, Vec3 offset) {
    auto eye = eye_beside(spacetime, camera, offset);
    REQUIRE_MESSAGE(eye, (eye ? "" : eye.error().what + eye.error().allowed));
    return *eye;
}

Vec3 place_of(const CameraSpec& camera) { return camera.r * world_from_static(camera.theta, camera.phi).a; }
// Columns: right, up, backward in world axes, before the boost.
Mat3 axes_of(const CameraSpec& camera) {
    return world_from_static(camera.theta, camera.phi) * static_from_camera(camera);
}

double difference(const Mat3& a, const Mat3& b) {
    return std::max({length(a.a - b.a), length(a.b - b.b), length(a.c - b.c)});
}

struct Case {
    const char* what;
    std::shared_ptr<const Spacetime> spacetime;
    CameraSpec camera;
};

std::vector<Case> cases() {
    CameraSpec turned{.r = 6, .theta = 1.2, .phi = 0.4, .yaw = 0.3, .pitch = -0.2, .roll = 0.5};
    const auto with = [&](ObserverKind observer, double r, Vec3 velocity = {}) {
        CameraSpec camera = turned;
        camera.observer = observer, camera.r = r, camera.velocity = velocity;
        return camera;
    };
    CameraSpec pole = with(ObserverKind::kStatic, 3);
    pole.theta = 0;
    const auto hole = world("schwarzschild"), spun = world("kerr", {{"spin", 0.9}});
    return {{"at rest", hole, with(ObserverKind::kStatic, 3)},
            {"at rest, moving", hole, with(ObserverKind::kStatic, 3, {0.1, -0.3, 0.5})},
            {"rain", hole, with(ObserverKind::kRain, 2)},
            {"rain inside", hole, with(ObserverKind::kRain, 0.6)},
            {"rain at the horizon", hole, with(ObserverKind::kRain, 1)},
            {"orbit", hole, with(ObserverKind::kOrbit, 4, {0.1, 0.2, 0})},
            {"above the pole", hole, pole},
            {"rotating, at rest", spun, with(ObserverKind::kStatic, 3)},
            {"rotating, orbit", spun, with(ObserverKind::kOrbit, 3)},
            {"rotating, rain inside", spun, with(ObserverKind::kRain, 0.65)},
            {"rotating, above the pole", spun, pole},
            {"wormhole", world("ellis"), with(ObserverKind::kStatic, 0.2)},
            {"wormhole's throat", world("ellis"), with(ObserverKind::kStatic, 0)}};
}

}  // namespace

TEST_CASE("eye: in flat spacetime a camera beside the camera, looking the same way") {
    const auto flat = world("minkowski");
    const CameraSpec camera{.r = 2, .theta = 1.1, .phi = 0.7, .yaw = 0.3, .pitch = -0.8, .roll = 0.4};
    const Vec3 offset{0.2, -0.1, 0.25};
    const Eye eye = eye_of(*flat, camera, offset);
    CHECK(length(place_of(eye.camera) - place_of(camera) - axes_of(camera) * offset) < kEyeRounding);
    CHECK(difference(axes_of(eye.camera), axes_of(camera)) < kEyeRounding);
    CHECK(eye.camera.velocity == Vec3{});
    CHECK(eye.later == doctest::Approx(0).epsilon(kEyeRounding));

    // Of a moving camera: what it takes for simultaneous, for it a length.
    CameraSpec moving = camera;
    moving.velocity = {0.3, 0.5, -0.2};
    const double gamma = 1 / std::sqrt(1 - dot(moving.velocity, moving.velocity));
    const Vec3 along = static_from_camera(moving) * offset;
    const double swept = gamma * dot(moving.velocity, along);
    const Vec3 step = along + swept * gamma / (1 + gamma) * moving.velocity;
    const Eye other = eye_of(*flat, moving, offset);
    const Mat3 world_axes = world_from_static(moving.theta, moving.phi);
    CHECK(other.later == doctest::Approx(swept).epsilon(kEyeRounding));
    CHECK(length(place_of(other.camera) - place_of(moving) - world_axes * step) < kEyeRounding);
    CHECK(length(world_from_static(other.camera.theta, other.camera.phi) * other.camera.velocity -
                 world_axes * moving.velocity) < kEyeRounding);
    CHECK(difference(axes_of(other.camera), axes_of(moving)) < kEyeRounding);
}

// The geodesic of the slice t = constant with the turning point r0: ds = dr/sqrt(A (1 - r0^2/r^2)), dphi = r0 ds/r^2. With r = r0 + x^2 both
// are smooth in x. The axes keep their angle to it.
TEST_CASE("eye: beside a camera at rest about a hole, by quadrature") {
    const double r0 = 3, whole = 0.7;
    const CameraSpec camera{.r = r0, .theta = 0.5 * kEyePi, .phi = 0.2};
    const Eye eye = eye_of(*world("schwarzschild"), camera, {whole, 0, 0});
    const double end = std::sqrt(eye.camera.r - r0);
    constexpr int kPanels = 2000;
    double length_along = 0, angle = 0;
    for (int i = 0; i < kPanels; ++i) {
        const double x = (i + 0.5) * end / kPanels, r = r0 + x * x;
        const double ds = 2 * r * end / kPanels / std::sqrt((1 - 1 / r) * (r + r0));
        length_along += ds, angle += r0 * ds / (r * r);
    }
    CHECK(length_along == doctest::Approx(whole).epsilon(1e-7));
    CHECK(eye.camera.phi - camera.phi == doctest::Approx(angle).epsilon(1e-7));
    CHECK(eye.camera.theta == doctest::Approx(0.5 * kEyePi).epsilon(kEyeRounding));
    CHECK(eye.camera.velocity == Vec3{});
    CHECK(std::fabs(eye.later) < kEyeRounding);
    // Its right axis is the geodesic's tangent, r0/r across.
    const Vec3 right = static_from_camera(eye.camera).a;
    CHECK(right.z == doctest::Approx(r0 / eye.camera.r).epsilon(kEyeRounding));
    CHECK(right.x > 0);
}

TEST_CASE("eye: back again, on in two steps, and what symmetries conserve") {
    for (const Case& each : cases()) {
        CAPTURE(each.what);
        const auto& spacetime = each.spacetime;
        const CameraSpec& camera = each.camera;
        const double scale = spacetime->areal_radius(camera.r);
        const Vec3 offset = scale * Vec3{0.05, 0.02, -0.03};
        const Eye eye = eye_of(*spacetime, camera, offset), half = eye_of(*spacetime, camera, 0.5 * offset),
                  on = eye_of(*spacetime, half.camera, 0.5 * offset), back = eye_of(*spacetime, eye.camera, -offset);
        for (const auto& [is, was] : {std::pair{&on.camera, &eye.camera}, {&back.camera, &camera}}) {
            CHECK(std::fabs(is->r - was->r) < kEyeRounding * scale);
            CHECK(length(world_from_static(is->theta, is->phi).a - world_from_static(was->theta, was->phi).a) <
                  kEyeRounding);
            CHECK(difference(axes_of(*is), axes_of(*was)) < kEyeRounding);
            CHECK(length(world_from_static(is->theta, is->phi) * is->velocity -
                         world_from_static(was->theta, was->phi) * was->velocity) < kEyeRounding);
        }
        CHECK(half.later + on.later == doctest::Approx(eye.later).epsilon(kEyeRounding));
        CHECK(eye.later + back.later == doctest::Approx(0).epsilon(kEyeRounding));
        // The components of d_v and, off the axis, of d_phi along the geodesic.
        const auto conserved = [&](const CameraSpec& there) -> std::array<double, 2> {
            const auto pair = ingoing_hat_pair(*spacetime, there);
            REQUIRE(pair);
            // eta_ab X^a X^b is known of every vector, so of X + d_v too: solve the rows for d_v and d_phi.
            double m[4][6]{};
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) m[j][i] = pair->high[i][j];
            m[0][4] = 1, m[3][5] = std::sin(there.theta);
            for (int k = 0; k < 4; ++k) {
                int pivot = k;
                for (int i = k; i < 4; ++i)
                    if (std::fabs(m[i][k]) > std::fabs(m[pivot][k])) pivot = i;
                std::swap(m[k], m[pivot]);
                for (int i = 0; i < 4; ++i) {
                    const double by = i == k ? 0 : m[i][k] / m[k][k];
                    for (int j = 0; j < 6; ++j) m[i][j] -= by * m[k][j];
                }
            }
            std::array<double, 2> along{};
            const double parts[] = {0, offset.x, offset.y, offset.z};
            for (int k = 0; k < 4; ++k)
                for (int n = 0; n < 2; ++n) along[n] += parts[k] * m[k][4 + n] / m[k][k];
            return along;
        };
        const auto first = conserved(camera), last = conserved(eye.camera);
        CHECK(last[0] == doctest::Approx(first[0]).epsilon(kEyeRounding));
        CHECK(last[1] == doctest::Approx(first[1]).epsilon(kEyeRounding));
    }
}

TEST_CASE("eye: there and back in every metric") {
    for (const MetricEntry& entry : metric_registry()) {
        if (entry.make == nullptr) continue;  // by formulas that a scene gives
        CAPTURE(entry.key);
        const auto spacetime = world(std::string(entry.key));
        const CameraSpec camera{.r = 4, .theta = 1.2, .phi = -3.1, .yaw = 2.0, .pitch = 0.4};
        const Vec3 offset{0.3, -0.2, 0.1};
        const Eye eye = eye_of(*spacetime, camera, offset), back = eye_of(*spacetime, eye.camera, -offset);
        CHECK(length(place_of(back.camera) - place_of(camera)) < kEyeRounding);
        CHECK(difference(axes_of(back.camera), axes_of(camera)) < kEyeRounding);
        CHECK(length(back.camera.velocity) < kEyeRounding);
        CHECK(length(place_of(eye.camera) - place_of(camera)) > 0.2);
    }
}

TEST_CASE("eye: refused where there is none") {
    const auto hole = world("schwarzschild");
    const CameraSpec low{.r = 1.001, .theta = 1.5};
    CHECK(eye_beside(*hole, low, {0, 0, 0.02}));                          // outward
    CHECK_FALSE(eye_beside(*hole, low, {0, 0, -0.1}));                    // beyond the horizon
    CHECK_FALSE(eye_beside(*hole, {.r = 4, .theta = 1.5}, {1.1, 0, 0}));  // kFarthestEye
}

TEST_CASE("stereo: a ball in flat spacetime, in each eye's picture of 8192 px") {
    const auto flat = world("minkowski");
    for (const Projection projection :
         {Projection::kPinhole, Projection::kFisheye, Projection::kEquirectangular, Projection::kCylindrical}) {
        CameraSpec camera{.r = 9, .theta = 1.3, .phi = 0.4, .yaw = 0.2, .pitch = 0.1, .roll = 0.3};
        camera.projection = projection;
        set_field_of_view(camera, usual_field_of_view(projection));
        camera.width = camera.height = 8192;
        camera.stereo = Stereo::kPair;
        const std::vector<EyePart> parts = eye_parts(camera);
        REQUIRE(parts.size() == 2);
        CHECK(parts[1].left == 8192);
        CHECK(stereo_size(camera) == std::array{16384, 8192});
        const Vec3 ball_there{0.4, -0.2, -3};  // in the camera's axes
        const Vec3 ball = place_of(camera) + axes_of(camera) * ball_there;
        double seen_x[2]{};
        for (int i = 0; i < 2; ++i) {
            const CameraSpec eye = eye_of(*flat, parts[i].camera, parts[i].offset).camera;
            const auto seen = pixel_of(eye, transposed(axes_of(eye)) * (ball - place_of(eye)));
            const Vec3 aside{(i == 0 ? -0.5 : 0.5) * camera.eye_distance, 0, 0};
            const auto wanted = pixel_of(camera, ball_there - aside);
            REQUIRE(seen);
            CHECK(std::hypot((*seen)[0] - (*wanted)[0], (*seen)[1] - (*wanted)[1]) < 0.01);
            seen_x[i] = (*seen)[0];
        }
        CHECK(seen_x[0] > seen_x[1] + 10);  // near things are farther right for the left eye
    }
}

// sin(longitude of the ball - column's) = half the eye distance over the level distance; the latitude is that from the eye.
TEST_CASE("stereo: all-round columns against the closed form, and seams within their bound") {
    const auto flat = world("minkowski");
    CameraSpec camera{.r = 9, .theta = 1.3, .phi = 0.4, .yaw = 0.2, .pitch = 0.1, .roll = 0.3};
    camera.projection = Projection::kEquirectangular;
    set_field_of_view(camera, 2 * kEyePi);
    camera.width = camera.height = 8192;
    camera.stereo = Stereo::kAllRound;
    const std::vector<EyePart> parts = eye_parts(camera);
    REQUIRE(parts.size() == 2 * 8192 / kStrip_px);
    CHECK(parts[parts.size() / 2].top == 8192);
    CHECK(stereo_size(camera) == std::array{8192, 16384});
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        const double longitude = -3.0 + 0.015 * i, latitude = -1.2 + 2.4 * std::fmod(0.618 * i, 1.0),
                     distance = camera.eye_distance * (i % 2 == 0 ? 80 : 5);
        const Vec3 there = distance * Vec3{std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                           -std::cos(latitude) * std::cos(longitude)};
        const Vec3 ball = place_of(camera) + axes_of(camera) * there;
        const double level = distance * std::cos(latitude), pixel = camera.pixel();
        double column[2]{};
        for (int side = 0; side < 2; ++side) {
            const double half = (side == 0 ? -0.5 : 0.5) * camera.eye_distance;
            const double x = 4096 + (longitude - std::asin(half / level)) / pixel,
                         y = 4096 - std::atan2(there.y, std::sqrt(level * level - half * half)) / pixel;
            const auto strip = static_cast<std::size_t>(x / kStrip_px);
            const EyePart& part = parts[side * parts.size() / 2 + strip];
            CHECK(part.left == static_cast<int>(strip) * kStrip_px);
            const CameraSpec eye = eye_of(*flat, part.camera, part.offset).camera;
            const auto seen = pixel_of(eye, transposed(axes_of(eye)) * (ball - place_of(eye)));
            REQUIRE(seen);
            const double in_picture = (*seen)[0] - part.skip + part.left,
                         off = std::hypot((in_picture - x) * std::cos(latitude), (*seen)[1] - y);
            CHECK(off < 0.5 * seam_px(camera, distance) + 0.01);
            worst = std::max(worst, off / seam_px(camera, distance));
            column[side] = in_picture;
        }
        CHECK(column[0] > column[1]);
    }
    CHECK(worst > 0.3);  // the bound is not far above
    CHECK(seam_px(camera, 80 * camera.eye_distance) <= 0.05);
}
