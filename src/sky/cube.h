// Geometry of a cube map's faces, by the OpenGL 3.3 core specification, table 3.19: order +x -x +y -y +z -z.
#pragma once
#include "base/vec.h"

namespace nullscope {

// Direction through texel position (u, v) in [0,1]^2 of a face (beyond it: of the plane that holds it), not normalised; and the face and
// position of a direction.
Vec3 cube_direction(int face, double u, double v);
struct CubePosition {
    int face;
    double u, v;
};
CubePosition cube_position(Vec3 direction);

// The same direction is middle + (2u - 1) right + (2v - 1) down; the three are orthonormal.
struct FaceAxes {
    Vec3 middle, right, down;
};
inline FaceAxes face_axes(int face) {
    const Vec3 middle = cube_direction(face, 0.5, 0.5);
    return {middle, cube_direction(face, 1.0, 0.5) - middle, cube_direction(face, 0.5, 1.0) - middle};
}

}  // namespace nullscope
