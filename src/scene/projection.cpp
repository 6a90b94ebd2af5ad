#include "scene/projection.h"

#include <algorithm>
#include <cmath>

#include "scene/warp_mesh.h"

namespace nullscope {
namespace {

// sin(angle)/angle
double sinc(double angle) { return angle == 0.0 ? 1.0 : std::sin(angle) / angle; }

struct Place {
    double u, v;
};

// The picture's middle from the line of sight, px of a pixel's height, right and up.
Place shifted_middle(const CameraSpec& camera) {
    return {camera.shift_x * camera.whole_width() * camera.pixel_aspect, camera.shift_y * camera.whole_height()};
}

// From the line of sight, px of a pixel's height.
Place place_px(const CameraSpec& camera, double x, double y) {
    if (!camera.warp.empty())
        if (const auto warped = warped_place(camera, x, y)) {
            const Place middle = shifted_middle(camera);
            return {warped->at[0] + middle.u, warped->at[1] + middle.v};
        }
    const auto [middle_x, middle_y] = line_of_sight(camera);
    return {(x - middle_x) * camera.pixel_aspect, middle_y - y};
}

Place place_of(const CameraSpec& camera, double x, double y) {
    const Place px = place_px(camera, x, y);
    return {px.u * camera.pixel(), px.v * camera.pixel()};
}

std::optional<std::array<double, 2>> pixel_at(const CameraSpec& camera, Place at) {
    const auto [middle_x, middle_y] = line_of_sight(camera);
    const double pixel = camera.pixel();
    if (!camera.warp.empty()) {
        const Place middle = shifted_middle(camera);
        const double turn = turn_px(camera) * camera.pixel_aspect;
        for (const double u : {at.u / pixel, at.u / pixel - turn, at.u / pixel + turn})
            if (const auto place = unwarped_place(camera, {u - middle.u, at.v / pixel - middle.v})) return place;
        return std::nullopt;
    }
    return std::array{middle_x + at.u / (camera.pixel_aspect * pixel), middle_y - at.v / pixel};
}

// Of a pixel's width, the root of areas: what the mesh makes of it.
double warp_share(const CameraSpec& camera, double x, double y) {
    if (camera.warp.empty()) return 1.0;
    const auto warped = warped_place(camera, x, y);
    return warped ? warped->share : 1.0;
}

// A face's axes: to the right and upward in it, and ahead through its middle.
struct Face {
    Vec3 right, up, ahead;
};
constexpr Face kFaces[] = {{{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                           {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                           {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};

// at: u and v, of which a face has 2 along each side.
int face_at(Place at) {
    const int column = std::clamp(static_cast<int>(std::floor(0.5 * at.u + 1.5)), 0, 2);
    return at.v >= 0.0 ? column : 3 + column;
}
Place face_middle(int face) { return {2.0 * (face % 3 - 1), face < 3 ? 1.0 : -1.0}; }
Place within_face(Place at) {
    const Place middle = face_middle(face_at(at));
    return {at.u - middle.u, at.v - middle.v};
}

double part_angle(Projection projection, double pixel, Place at) {
    switch (projection) {
        case Projection::kFisheye:
        case Projection::kEquirectangular: return pixel;
        case Projection::kCylindrical: at.u = 0.0; break;
        case Projection::kCube: at = within_face(at); break;
        case Projection::kPinhole: break;
    }
    const double inverse = 1 / std::sqrt(1 + at.u * at.u + at.v * at.v);
    return pixel * inverse * std::sqrt(inverse);
}

}  // namespace

std::array<double, 2> line_of_sight(const CameraSpec& camera) {
    return {(0.5 - camera.shift_x) * camera.whole_width() - (camera.part ? camera.part->left : 0),
            (0.5 + camera.shift_y) * camera.whole_height() - (camera.part ? camera.part->top : 0)};
}

Vec3 pixel_direction(const CameraSpec& camera, double x, double y) {
    const auto [u, v] = place_of(camera, x, y);
    switch (camera.projection) {
        case Projection::kFisheye: {
            const double angle = std::hypot(u, v), scale = sinc(angle);
            return {scale * u, scale * v, -std::cos(angle)};
        }
        case Projection::kEquirectangular: return {std::cos(v) * std::sin(u), std::sin(v), -std::cos(v) * std::cos(u)};
        case Projection::kCylindrical: return {std::sin(u), v, -std::cos(u)};
        case Projection::kCube: {
            const Face& face = kFaces[face_at({u, v})];
            const Place in = within_face({u, v});
            return in.u * face.right + in.v * face.up + face.ahead;
        }
        case Projection::kPinhole: break;
    }
    return {u, v, -1.0};
}

std::optional<std::array<double, 2>> pixel_of(const CameraSpec& camera, Vec3 direction) {
    const double right = direction.x, up = direction.y, ahead = -direction.z, level = std::hypot(right, ahead);
    Place at{};
    switch (camera.projection) {
        case Projection::kPinhole:
            if (!(ahead > 0.0)) return std::nullopt;
            at = {right / ahead, up / ahead};
            break;
        case Projection::kFisheye: {
            const double aside = std::hypot(right, up), angle = std::atan2(aside, ahead);
            at = aside > 0.0 ? Place{angle * right / aside, angle * up / aside} : Place{angle, 0.0};
            break;
        }
        case Projection::kEquirectangular: at = {std::atan2(right, ahead), std::atan2(up, level)}; break;
        case Projection::kCylindrical:
            if (!(level > 0.0)) return std::nullopt;
            at = {std::atan2(right, ahead), up / level};
            break;
        case Projection::kCube: {
            int face = 0;
            for (int i = 1; i < 6; ++i)
                if (dot(direction, kFaces[i].ahead) > dot(direction, kFaces[face].ahead)) face = i;
            return pixel_on_face(camera, face, direction);
        }
    }
    return pixel_at(camera, at);
}

std::optional<std::array<double, 2>> pixel_on_face(const CameraSpec& camera, int face, Vec3 direction) {
    const Face& on = kFaces[face];
    const double far = dot(direction, on.ahead);
    if (!(far > 0.0)) return std::nullopt;
    const Place middle = face_middle(face);
    return pixel_at(camera, {middle.u + dot(direction, on.right) / far, middle.v + dot(direction, on.up) / far});
}

int cube_face(const CameraSpec& camera, double x, double y) {
    return camera.projection == Projection::kCube ? face_at(place_of(camera, x, y)) : 0;
}

bool shows(const CameraSpec& camera, double x, double y) {
    if (!camera.warp.empty() && !warped_place(camera, x, y)) return false;
    const auto [right, up] = place_px(camera, x, y);
    return (camera.projection == Projection::kFisheye ? std::hypot(right, up) : std::fabs(up)) <= shown_px(camera);
}

double shown_px(const CameraSpec& camera) {
    if (camera.projection == Projection::kFisheye) return 0.5 * camera.plane_width / camera.pixel();
    if (camera.projection == Projection::kCube) return 2.0 / camera.pixel();
    return camera.projection == Projection::kEquirectangular ? 0.5 * M_PI / camera.pixel() : 1e9;
}

double pixel_solid_angle(const CameraSpec& camera, double x, double y) {
    const double pixel = camera.pixel(), share = warp_share(camera, x, y),
                 square = pixel * pixel * camera.pixel_aspect * share * share;
    auto [u, v] = place_of(camera, x, y);
    switch (camera.projection) {
        case Projection::kCube: {
            const Place in = within_face({u, v});
            u = in.u, v = in.v;
            break;
        }
        case Projection::kFisheye: return square * std::fabs(sinc(std::hypot(u, v)));
        case Projection::kEquirectangular: return square * std::fabs(std::cos(v));
        case Projection::kCylindrical: return square * std::pow(1 + v * v, -1.5);
        case Projection::kPinhole: break;
    }
    return square * std::pow(1 + u * u + v * v, -1.5);
}

double pixel_angle(const CameraSpec& camera, double x, double y) {
    return part_angle(camera.projection, camera.pixel(), place_of(camera, x, y)) * std::sqrt(camera.pixel_aspect) *
           std::max(warp_share(camera, x, y), kNarrowestShare);
}

double smallest_pixel_angle(const CameraSpec& camera) {
    const auto [right, up] = reach(camera);
    const double pixel = camera.pixel();
    if (camera.projection == Projection::kCube) return part_angle(Projection::kPinhole, pixel, {1.0, 1.0});
    return part_angle(camera.projection, pixel, {right * pixel, up * pixel}) * std::sqrt(camera.pixel_aspect) *
           smallest_warp_share(camera);
}

double turn_px(const CameraSpec& camera) {
    const bool round =
        camera.projection == Projection::kEquirectangular || camera.projection == Projection::kCylindrical;
    return round ? 2.0 * M_PI / (camera.pixel_aspect * camera.pixel()) : 0.0;
}

std::array<double, 2> reach(const CameraSpec& camera) {
    const double right = (0.5 + std::fabs(camera.shift_x)) * camera.whole_width() * camera.pixel_aspect;
    return {right, (0.5 + std::fabs(camera.shift_y)) * camera.whole_height()};
}

double reach_px(const CameraSpec& camera) {
    const auto [right, up] = reach(camera);
    return std::hypot(right, up);
}

double reach_angle(const CameraSpec& camera) {
    const auto [right, up] = reach(camera);
    const double pixel = camera.pixel();
    switch (camera.projection) {
        case Projection::kPinhole: return std::atan(std::hypot(right, up) * pixel);
        case Projection::kCylindrical: return std::min(std::hypot(right * pixel, std::atan(up * pixel)), M_PI);
        case Projection::kCube: return M_PI;
        case Projection::kFisheye:
        case Projection::kEquirectangular: break;
    }
    return std::min(std::hypot(right, up) * pixel, M_PI);
}

double field_of_view(const CameraSpec& camera) {
    return camera.projection == Projection::kPinhole ? 2.0 * std::atan2(0.5 * camera.plane_width, camera.focal_distance)
                                                     : camera.plane_width;
}

void set_field_of_view(CameraSpec& camera, double angle) {
    camera.plane_width = camera.projection == Projection::kPinhole ? 2.0 * std::tan(0.5 * angle) : angle;
    camera.focal_distance = 1.0;
}

double usual_field_of_view(Projection projection) {
    switch (projection) {
        case Projection::kPinhole: break;
        case Projection::kFisheye: return M_PI;
        case Projection::kEquirectangular:
        case Projection::kCylindrical: return 2.0 * M_PI;
        case Projection::kCube: return 6.0;
    }
    return M_PI / 3.0;
}

}  // namespace nullscope
