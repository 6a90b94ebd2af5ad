// Where a camera's pixels look: its projection, and the inverse. Positions are px from the picture's upper left corner, pixel centres at
// +0.5; directions are in the camera's own axes (right, up, backward).
#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

// With (u, v) the position in pixels from the line of sight, right and up, times CameraSpec::pixel():
//   pinhole           (u, v, -1), not of unit length
//   fisheye           azimuthal equidistant: hypot(u, v) from the line of sight, towards (u, v)
//   equirectangular   longitude u to the right, latitude v
//   cylindrical       longitude u, tangent v of the latitude
//   cube              three columns and two rows of square faces, each a pinhole's picture of 90 degrees: left, ahead, right above down,
//                     behind, up. The line of sight counts as the picture's middle.
// Where a camera has a mesh (scene/warp_mesh.h), (u, v) is where that takes the pixel; beside it as without one.
Vec3 pixel_direction(const CameraSpec& camera, double x, double y);
// Where a direction of any length is seen, also beside the picture; nothing behind a pinhole, nor beside a mesh. Of several places (longitudes, the
// fisheye's antipode) the one nearest to the line of sight.
std::optional<std::array<double, 2>> pixel_of(const CameraSpec& camera, Vec3 direction);
// Of the line of sight.
std::array<double, 2> line_of_sight(const CameraSpec& camera);
// Of a cube: the face, 0 to 5 in the order above; 0 of other projections.
int cube_face(const CameraSpec& camera, double x, double y);
// Where a direction is seen in the plane of one face, also beyond its square; nothing behind it.
std::optional<std::array<double, 2>> pixel_on_face(const CameraSpec& camera, int face, Vec3 direction);
// Whether the picture shows anything there: of a fisheye within its circle, of equirectangular pictures between the poles, of a mesh
// within it.
bool shows(const CameraSpec& camera, double x, double y);
// How far from the line of sight that is, px of a pixel's height: a fisheye's radius, an equirectangular picture's height; else 1e9.
double shown_px(const CameraSpec& camera);

double pixel_solid_angle(const CameraSpec& camera, double x, double y);  // sr
// What a pixel spans, rad, to count errors in: the square root of its solid angle. Where a fisheye's and an equirectangular picture's
// pixels become narrow strips, towards the antipode and the poles, still that in the middle.
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
// Of other projections than the pinhole, rad: narrower views need its exactness next to the line of sight.
inline constexpr double kNarrowestWide = 10.0 * M_PI / 180.0;
// What a projection has unless a scene says otherwise: 60, 180, 360 and 360 degrees; of a cube what stands for three faces.
double usual_field_of_view(Projection projection);

}  // namespace nullscope
