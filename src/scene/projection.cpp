#include "scene/projection.h"

#include <algorithm>
#include <cmath>

#include "scene/warp_mesh.h"

namespace nullscope {
namespace {

// The picture's middle from the line of sight, px of a pixel's height, right and up.
ImagePlace shifted_middle(const CameraSpec& camera) {
    return {camera.shift_x * camera.whole_width() * camera.pixel_aspect, camera.shift_y * camera.whole_height()};
}

// From the line of sight, px of a pixel's height.
ImagePlace place_px(const CameraSpec& camera, double x, double y) {
    if (!camera.warp.empty())
        if (const auto warped = warped_place(camera, x, y)) {
            const ImagePlace middle = shifted_middle(camera);
            return {warped->at[0] + middle.u, warped->at[1] + middle.v};
        }
    const auto [middle_x, middle_y] = line_of_sight(camera);
    return {(x - middle_x) * camera.pixel_aspect, middle_y - y};
}

ImagePlace place_of(const CameraSpec& camera, double x, double y) {
    const ImagePlace px = place_px(camera, x, y);
    return {px.u * camera.pixel(), px.v * camera.pixel()};
}

std::optional<std::array<double, 2>> pixel_at(const CameraSpec& camera, ImagePlace at) {
    const auto [middle_x, middle_y] = line_of_sight(camera);
    const double pixel = camera.pixel();
    if (!camera.warp.empty()) {
        const ImagePlace middle = shifted_middle(camera);
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

}  // namespace

std::array<double, 2> line_of_sight(const CameraSpec& camera) {
    return {(0.5 - camera.shift_x) * camera.whole_width() - (camera.part ? camera.part->left : 0),
            (0.5 + camera.shift_y) * camera.whole_height() - (camera.part ? camera.part->top : 0)};
}

double CameraSpec::pixel() const {
    const ProjectionRow& row = projection_row(projection);
    const double across = whole_width() * pixel_aspect, side = row.circle ? std::fmin(across, whole_height()) : across,
                 wide = row.width != nullptr && !row.flat ? row.width(plane_width) : plane_width;
    return wide / side / focal_distance * (zoom ? std::exp(-zoom->depth) : 1.0);
}

Vec3 pixel_direction(const CameraSpec& camera, double x, double y) {
    return projection_of(camera).direction(place_of(camera, x, y));
}

std::optional<std::array<double, 2>> pixel_of(const CameraSpec& camera, Vec3 direction) {
    const auto at = projection_of(camera).place(direction);
    return at ? pixel_at(camera, *at) : std::nullopt;
}

std::optional<std::array<double, 2>> pixel_on_face(const CameraSpec& camera, int face, Vec3 direction) {
    const auto at = cube_face_place(face, direction);
    return at ? pixel_at(camera, *at) : std::nullopt;
}

int cube_face(const CameraSpec& camera, double x, double y) {
    return projection_of(camera).faces ? cube_face_at(place_of(camera, x, y)) : 0;
}

bool shows(const CameraSpec& camera, double x, double y) {
    if (!camera.warp.empty() && !warped_place(camera, x, y)) return false;
    const auto [right, up] = place_px(camera, x, y);
    return (projection_of(camera).circle ? std::hypot(right, up) : std::fabs(up)) <= shown_px(camera);
}

double shown_px(const CameraSpec& camera) {
    constexpr double kEverywhere_px = 1e9;
    const auto shown = projection_of(camera).shown;
    return shown != nullptr ? shown(camera.plane_width) / camera.pixel() : kEverywhere_px;
}

double pixel_solid_angle(const CameraSpec& camera, double x, double y) {
    const double pixel = camera.pixel(), share = warp_share(camera, x, y),
                 square = pixel * pixel * camera.pixel_aspect * share * share;
    return square * projection_of(camera).area(place_of(camera, x, y));
}

double pixel_angle(const CameraSpec& camera, double x, double y) {
    return projection_of(camera).angle(camera.pixel(), place_of(camera, x, y)) * std::sqrt(camera.pixel_aspect) *
           std::max(warp_share(camera, x, y), kNarrowestShare);
}

double smallest_pixel_angle(const CameraSpec& camera) {
    const auto [right, up] = reach(camera);
    const double pixel = camera.pixel();
    return projection_of(camera).angle(pixel, {right * pixel, up * pixel}) * std::sqrt(camera.pixel_aspect) *
           smallest_warp_share(camera);
}

double turn_px(const CameraSpec& camera) {
    return projection_of(camera).round ? 2.0 * M_PI / (camera.pixel_aspect * camera.pixel()) : 0.0;
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
    return projection_of(camera).aside(right, up, camera.pixel());
}

double field_of_view(const CameraSpec& camera) {
    return projection_of(camera).flat ? 2.0 * std::atan2(0.5 * camera.plane_width, camera.focal_distance)
                                      : camera.plane_width;
}

void set_field_of_view(CameraSpec& camera, double angle) {
    const ProjectionRow& row = projection_of(camera);
    camera.plane_width = row.flat ? row.width(angle) : angle;
    camera.focal_distance = 1.0;
}

}  // namespace nullscope
