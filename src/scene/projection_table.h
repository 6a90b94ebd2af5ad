// All projections. A row is added by a file, an enumerator of Projection and a line here.
#pragma once
#include "scene/projection_cube.h"
#include "scene/projection_cylindrical.h"
#include "scene/projection_equirectangular.h"
#include "scene/projection_fisheye.h"
#include "scene/projection_kind.h"
#include "scene/projection_pinhole.h"
#include "scene/projection_stereographic.h"

namespace nullscope {

inline constexpr const ProjectionRow* kProjectionRows[] = {
    // by Projection
    &kPinholeProjection,          //
    &kFisheyeProjection,          //
    &kEquirectangularProjection,  //
    &kCylindricalProjection,      //
    &kCubeProjection,             //
    &kStereographicProjection,    //
};
static_assert(sizeof kProjectionRows / sizeof kProjectionRows[0] == kProjections);

constexpr const ProjectionRow& projection_row(Projection projection) {
    return *kProjectionRows[static_cast<int>(projection)];
}

}  // namespace nullscope
