// A camera's projection: directions against formulas by turns about axes, the inverse, solid angles, parts of a picture.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "scene/projection.h"

namespace {

using namespace nullscope;

constexpr double kProjectionRounding = 1e-14;

CameraSpec camera_of(Projection projection, int width, int height, double fov) {
    CameraSpec camera;
    camera.projection = projection;
    camera.width = width, camera.height = height;
    set_field_of_view(camera, fov);
    return camera;
}

// Right-handed, about the upward and the right axis, which take forward (0, 0, -1) to the right and upward.
Vec3 turned_right(Vec3 v, double a) {
    return {std::cos(a) * v.x - std::sin(a) * v.z, v.y, std::cos(a) * v.z + std::sin(a) * v.x};
}
Vec3 turned_up(Vec3 v, double a) {
    return {v.x, std::cos(a) * v.y - std::sin(a) * v.z, std::cos(a) * v.z + std::sin(a) * v.y};
}
Vec3 rolled(Vec3 v, double a) {
    return {std::cos(a) * v.x - std::sin(a) * v.y, std::cos(a) * v.y + std::sin(a) * v.x, v.z};
}

// u, v: from the picture's middle, right and up, in parts of half its width or, of a fisheye, of its smaller side.
Vec3 by_turns(Projection projection, double fov, double u, double v) {
    const Vec3 forward{0, 0, -1};
    const double half = 0.5 * fov;
    switch (projection) {
        case Projection::kFisheye: return rolled(turned_right(forward, half * std::hypot(u, v)), std::atan2(v, u));
        case Projection::kEquirectangular: return turned_right(turned_up(forward, half * v), half * u);
        case Projection::kCylindrical: return turned_right(turned_up(forward, std::atan(half * v)), half * u);
        case Projection::kCube: {
            const int column = static_cast<int>(std::floor(1.5 * u + 1.5));
            const double a = 3 * u - 2 * (column - 1), b = 3 * v - (v > 0 ? 1 : -1);
            const Vec3 ahead = by_turns(Projection::kPinhole, M_PI / 2, a, b);
            if (v > 0) return turned_right(ahead, 0.5 * M_PI * (column - 1));
            return column == 1 ? turned_right(ahead, M_PI) : turned_up(ahead, 0.5 * M_PI * (column - 1));
        }
        case Projection::kStereographic:
            return rolled(turned_right(forward, 2 * std::atan(std::tan(0.5 * half) * std::hypot(u, v))),
                          std::atan2(v, u));
        case Projection::kPinhole:
        case Projection::kEnd: break;
    }
    return turned_right(turned_up(forward, std::atan(std::tan(half) * v * std::cos(std::atan(std::tan(half) * u)))),
                        std::atan(std::tan(half) * u));
}

struct ProjectionCase {
    Projection projection;
    int width, height;
    double fov;
};
const std::vector<ProjectionCase> kCases = [] {
    std::vector<ProjectionCase> cases = {{Projection::kPinhole, 300, 200, 1.2},
                                         {Projection::kFisheye, 200, 200, M_PI},
                                         {Projection::kFisheye, 300, 200, 2 * M_PI},
                                         {Projection::kEquirectangular, 400, 200, 2 * M_PI},
                                         {Projection::kEquirectangular, 300, 200, 1.5},
                                         {Projection::kCylindrical, 400, 300, 2 * M_PI},
                                         {Projection::kCube, 300, 200, 6.0},
                                         {Projection::kStereographic, 300, 200, 6.0}};
    for (int i = 0; i < kProjections; ++i)  // each as scenes have it
        cases.push_back({static_cast<Projection>(i), 300, 200, usual_field_of_view(static_cast<Projection>(i))});
    return cases;
}();

TEST_CASE("projection: directions are those of turns about the camera's axes, and are found again") {
    for (const ProjectionCase& one : kCases)
        for (const double aspect : {1.0, 1.6}) {
            if (one.projection == Projection::kCube && aspect != 1.0) continue;
            CameraSpec camera = camera_of(one.projection, one.width, one.height, one.fov);
            camera.pixel_aspect = aspect, camera.shift_x = aspect - 1.0, camera.shift_y = 0.2 * (aspect - 1.0);
            const double across = one.width * aspect,
                         side = projection_row(one.projection).circle ? std::fmin(across, one.height) : across;
            double off = 0.0, again = 0.0;
            for (double y = 0.5; y < one.height; y += 7.0)
                for (double x = 0.5; x < one.width; x += 7.0) {
                    const double u = (x - (0.5 - camera.shift_x) * one.width) * aspect / (0.5 * side),
                                 v = ((0.5 + camera.shift_y) * one.height - y) / (0.5 * side);
                    if (!shows(camera, x, y)) continue;
                    if (one.projection != Projection::kCube && std::fabs(u * one.fov) > 2 * M_PI)
                        continue;  // round the camera: the place is another one
                    const Vec3 direction = pixel_direction(camera, x, y);
                    off = std::fmax(off, length(normalized(direction) - by_turns(one.projection, one.fov, u, v)));
                    const auto place = pixel_of(camera, direction);
                    REQUIRE(place);
                    again = std::fmax(again, std::hypot((*place)[0] - x, (*place)[1] - y));
                }
            CAPTURE(projection_name(one.projection));
            CHECK(off < 10 * kProjectionRounding);
            CHECK(again < 1e-9);
        }
}

TEST_CASE("projection: a pixel's solid angle is that of its corners, and all of the sky is 4 pi") {
    for (const ProjectionCase& one : kCases) {
        const CameraSpec camera = camera_of(one.projection, one.width, one.height, one.fov);
        for (double y = 20.5; y < one.height; y += 37.0)
            for (double x = 20.5; x < one.width; x += 37.0) {
                constexpr double kSide = 1e-4;  // px
                const auto at = [&](double dx, double dy) {
                    return normalized(pixel_direction(camera, x + kSide * dx, y + kSide * dy));
                };
                const Vec3 by_x = (at(0.5, 0) - at(-0.5, 0)) / kSide, by_y = (at(0, 0.5) - at(0, -0.5)) / kSide;
                CHECK(length(cross(by_x, by_y)) ==
                      doctest::Approx(pixel_solid_angle(camera, x, y)).epsilon(1e-6).scale(1e-6));
            }
    }
    for (const auto& [projection, width] :

         {std::pair{Projection::kFisheye, 400}, {Projection::kEquirectangular, 800}, {Projection::kCube, 600}}) {
        const CameraSpec camera = camera_of(projection, width, 400, projection == Projection::kCube ? 6.0 : 2 * M_PI);
        double sum = 0.0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                if (shows(camera, x + 0.5, y + 0.5)) sum += pixel_solid_angle(camera, x + 0.5, y + 0.5);
        CHECK(sum == doctest::Approx(4 * M_PI).epsilon(1e-4));
    }
}

TEST_CASE("projection: a part of a picture shows the whole's directions, bit by bit") {
    for (const ProjectionCase& one : kCases) {
        CameraSpec whole = camera_of(one.projection, one.width, one.height, one.fov);
        whole.shift_x = one.projection == Projection::kCube ? 0.0 : 0.25;
        CameraSpec part = whole;
        part.part = PicturePart{64, 40, whole.width, whole.height};
        part.width = 32, part.height = 16;
        CHECK(part.pixel() == whole.pixel());
        CHECK(reach_angle(part) == reach_angle(whole));
        for (double y = 0.5; y < part.height; ++y)
            for (double x = 0.5; x < part.width; ++x) {
                CHECK(pixel_direction(part, x, y) == pixel_direction(whole, x + 64, y + 40));
                CHECK(shows(part, x, y) == shows(whole, x + 64, y + 40));
            }
    }
}

TEST_CASE("projection: how far a picture reaches, and where it comes round") {
    const CameraSpec sky = camera_of(Projection::kEquirectangular, 400, 200, 2 * M_PI);
    CHECK(turn_px(sky) == doctest::Approx(400.0));
    CHECK(reach_angle(sky) == M_PI);
    CHECK(turn_px(camera_of(Projection::kPinhole, 400, 200, 1.0)) == 0.0);
    const CameraSpec dome = camera_of(Projection::kFisheye, 400, 400, M_PI);
    CHECK(shows(dome, 0.5, 200.0));
    CHECK_FALSE(shows(dome, 50.0, 50.0));
    CHECK(shown_px(dome) == doctest::Approx(200.0));
    CHECK(pixel_direction(dome, 400.0, 200.0).x == doctest::Approx(1.0));
    CHECK_FALSE(pixel_of(camera_of(Projection::kPinhole, 400, 200, 1.0), {0, 0, 1}));
    for (const ProjectionCase& one : kCases) {
        CameraSpec camera = camera_of(one.projection, one.width, one.height, one.fov);
        CHECK(field_of_view(camera) == doctest::Approx(one.fov));
    }
}

// In px from the picture's middle, right and up.
std::array<double, 2> seen_at(const CameraSpec& camera, Vec3 direction) {
    const auto place = pixel_of(camera, direction);
    REQUIRE(place);
    return {(*place)[0] - 0.5 * camera.width, 0.5 * camera.height - (*place)[1]};
}

TEST_CASE("projection: stereographic circles are circles, and angles are angles, also far behind") {
    const CameraSpec camera = camera_of(Projection::kStereographic, 400, 200, 350 * M_PI / 180);
    const CameraSpec half = camera_of(Projection::kStereographic, 400, 200, M_PI);
    CHECK(seen_at(half, {1, 0, 0})[0] == doctest::Approx(200.0));  // at the edge
    CHECK(seen_at(half, {std::sin(0.5), 0, -std::cos(0.5)})[0] == doctest::Approx(200.0 * std::tan(0.25)));
    for (const double off : {0.3, 1.2, 2.0, 2.9})  // of the circle's centre from the line of sight
        for (const double radius : {1e-3, 0.2, 1.0}) {
            const auto on = [&](double turn) {
                return rolled(turned_right(rolled(turned_right({0, 0, -1}, radius), turn), off), 0.7);
            };
            // Its centre and radius: both ends of the diameter through the line of sight.
            const auto near = seen_at(camera, on(M_PI)), far = seen_at(camera, on(0.0));
            const double x = 0.5 * (near[0] + far[0]), y = 0.5 * (near[1] + far[1]),
                         wide = std::hypot(near[0] - x, near[1] - y);
            for (double turn = 0.1; turn < 6.2; turn += 0.3) {
                const auto at = seen_at(camera, on(turn));
                CHECK(std::hypot(at[0] - x, at[1] - y) == doctest::Approx(wide).epsilon(1e-9));
            }
            // A step along it and one across it are at right angles, and as long as each other.
            constexpr double kStep = 1e-5;
            const Vec3 here = on(1.0), along = normalized(on(1.0 + kStep) - on(1.0 - kStep)),
                       across = cross(here, along);
            const auto step = [&](Vec3 v) {
                const auto after = seen_at(camera, here + kStep * v), before = seen_at(camera, here - kStep * v);
                return std::array{after[0] - before[0], after[1] - before[1]};
            };
            const auto a = step(along), b = step(across);
            CHECK(a[0] == doctest::Approx(-b[1]).epsilon(1e-4).scale(std::hypot(a[0], a[1])));
            CHECK(a[1] == doctest::Approx(b[0]).epsilon(1e-4).scale(std::hypot(a[0], a[1])));
        }
    CHECK_FALSE(pixel_of(camera, {0, 0, 1}));
}

TEST_CASE("projection: the faces of a cube meet without a seam") {
    const CameraSpec cube = camera_of(Projection::kCube, 300, 200, 6.0);
    // Along the edges of the face ahead: the same direction in the plane of the face beside it.
    constexpr int kBeside[] = {0, 2, 3, 5};
    for (const int face : kBeside)
        for (int i = 0; i <= 100; ++i) {
            const double x = face == 0 ? 100 : face == 2 ? 200 : 100 + i, y = face == 5 ? 0 : face == 3 ? 100 : i;
            const Vec3 d =
                pixel_direction(cube, std::fmin(std::fmax(x, 100 + 1e-9), 200 - 1e-9), std::fmin(y, 100 - 1e-9));
            const auto on = pixel_on_face(cube, face, d);
            REQUIRE(on);
            // Left and right of it edge to edge in the picture; up and down are the lower row's.
            const double wanted_x = face == 0   ? 100
                                    : face == 2 ? 200
                                    : face == 3 ? i
                                                : 200 + i,
                         wanted_y = face == 5   ? 200
                                    : face == 3 ? 100
                                                : i;
            CHECK(std::hypot((*on)[0] - wanted_x, (*on)[1] - wanted_y) < 1e-6);
        }
}

}  // namespace
