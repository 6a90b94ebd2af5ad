// A path's cameras as a table (CSV), a row a key: to and from programs that animate. docs/scenes.md says which columns there are.
//
// Columns are called as the keys of [camera] and [zoom], have their units and ranges, and may stand in any order; velocity_r,
// velocity_theta, velocity_phi are the components of camera.velocity; x, y, z may stand for r, theta, phi: r_s, as if these were spherical
// coordinates of flat space; look_x ... up_z or qw ... qz, the camera's axes in world axes (observer/pose.h), for yaw, pitch, roll, of which look_x ... up_z may also be a second copy, within 1e-4: qw ...
// turns x, y, z into right, up, backward, which are also the axes of a camera in Blender. What has no column is as in the scene's [camera]; without a column frame the rows are frames 0, 1, ...
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr std::size_t kMostPathRows = 100000;

struct PathTable {
    std::vector<PathKey> keys;  // two or more
    bool by_axes = false;       // with columns look_x ... or qw ..., and without yaw, pitch, roll
};

// scene: whose spacetime they are in, and whose camera has what the table does not say. Errors: as of a scene file, with
// the table's line and column. Cost: some microseconds a row, more in spacetimes that are slow to make.
Result<PathTable> read_path_csv(const std::string& text, const std::string& label, const Scene& scene);

enum class PathPlaces { kSpherical, kCartesian };
// With all that is not the default in some row, and the camera's axes, of unit length, as angles and, without [zoom], as look_x ... up_z. Numbers read back as the same ones, or the next to them; x, y, z to rounding. Errors:
// angles beyond a key's range; Cartesian places on the other side of a wormhole.
Result<std::string> path_csv(const std::vector<PathKey>& keys, PathPlaces places);

}  // namespace nullscope
