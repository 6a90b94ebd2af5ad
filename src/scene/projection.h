// Where a camera's pixels look: its projection, and the inverse. Positions are px from the picture's upper left corner, pixel centres at
// +0.5; directions are in the camera's own axes (right, up, backward).
#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "base/vec.h"
#include "scene/projection_table.h"
#include "scene/scene.h"

namespace nullscope {

inline const ProjectionRow& projection_of(const CameraSpec& camera) { return projection_row(camera.projection); }
constexpr std::string_view projection_name(Projection projection) { return projection_row(projection).name; }

// Of the projection's row, at (u, v), the position in pixels from the line of sight, right and up, times CameraSpec::pixel(). Where a camera
// has a mesh (scene/warp_mesh.h), (u, v) is where that takes the pixel; beside it as without one.
Vec3 pixel_direction(const CameraSpec& camera, double x, double y);
// Where a direction of any length is seen, also beside the picture; nothing behind a pinhole, nor beside a mesh. Of several places (longitudes, the
// fisheye's antipode) the one nearest to the line of sight.
std::optional<std::array<double, 2>> pixel_of(const CameraSpec& camera, Vec3 direction);
// Of the line of sight.
std::array<double, 2> line_of_sight(const CameraSpec& camera);
// Of a cube: the face, 0 to 5 in the order of its row; 0 of other projections.
int cube_face(const CameraSpec& camera, double x, double y);
// Where a direction is seen in the plane of one face, also beyond its square; nothing behind it.
std::optional<std::array<double, 2>> pixel_on_face(const CameraSpec& camera, int face, Vec3 direction);
// Whether the picture shows anything there, as its row says, and of a mesh within it.
bool shows(const CameraSpec& camera, double x, double y);
// How far from the line of sight that is, px of a pixel's height: a circle's radius, else half the height; 1e9 where it is everything.
double shown_px(const CameraSpec& camera);

double pixel_solid_angle(const CameraSpec& camera, double x, double y);  // sr
// What a pixel spans, rad, to count errors in (ProjectionRow::angle).
double pixel_angle(const CameraSpec& camera, double x, double y);
double smallest_pixel_angle(const CameraSpec& camera);  // in the frame

// Of projections that go round: how far apart the places are at which a direction is seen, px; else 0.
double turn_px(const CameraSpec& camera);

// From the line of sight to the farther sides of the picture (right or left, above or below) and to its farthest corner, px of a pixel's
// height; and at most, rad. Of a part that of the whole picture.
std::array<double, 2> reach(const CameraSpec& camera);
double reach_px(const CameraSpec& camera);
double reach_angle(const CameraSpec& camera);

// The angle that plane_width spans, rad.
double field_of_view(const CameraSpec& camera);
void set_field_of_view(CameraSpec& camera, double angle);
constexpr double usual_field_of_view(Projection projection) { return projection_row(projection).field.usual; }

}  // namespace nullscope
