// The kinds of projections, by number: the value of frame.projection.x in shaders too. A row each: scene/projection_table.h.
#pragma once

namespace nullscope {

enum class Projection { kPinhole, kFisheye, kEquirectangular, kCylindrical, kCube, kStereographic, kEnd };
inline constexpr int kProjections = static_cast<int>(Projection::kEnd);

}  // namespace nullscope
