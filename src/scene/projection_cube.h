// Three columns and two rows of square faces, each a pinhole's picture of 90 degrees: left, ahead, right above down, behind, up. The line of
// sight counts as the picture's middle.
#pragma once
#include <algorithm>

#include "scene/projection_pinhole.h"

namespace nullscope {

// A face's axes: to the right and upward in it, and ahead through its middle.
struct CubeFace {
    Vec3 right, up, ahead;
};
inline constexpr int kFacesOfCube = 6;
inline constexpr CubeFace kCubeFaceAxes[kFacesOfCube] = {
    {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};

// at: u and v, of which a face has 2 along each side.
inline int cube_face_at(ImagePlace at) {
    const int column = std::clamp(static_cast<int>(std::floor(0.5 * at.u + 1.5)), 0, 2);
    return at.v >= 0.0 ? column : 3 + column;
}
inline ImagePlace cube_face_middle(int face) { return {2.0 * (face % 3 - 1), face < 3 ? 1.0 : -1.0}; }
inline ImagePlace within_cube_face(ImagePlace at) {
    const ImagePlace middle = cube_face_middle(cube_face_at(at));
    return {at.u - middle.u, at.v - middle.v};
}
// Where a direction is in the plane of one face, also beyond its square; nothing behind it.
inline std::optional<ImagePlace> cube_face_place(int face, Vec3 direction) {
    const CubeFace& on = kCubeFaceAxes[face];
    const double far = dot(direction, on.ahead);
    if (!(far > 0.0)) return std::nullopt;
    const ImagePlace middle = cube_face_middle(face);
    return ImagePlace{middle.u + dot(direction, on.right) / far, middle.v + dot(direction, on.up) / far};
}

inline constexpr ProjectionRow kCubeProjection{
    .name = "cube",
    .is = "six faces, left, ahead, right above down, behind, up",
    .effect = "cube-faces",
    .define = "EFFECT_CUBE_FACES",
    .help = "The picture is the six faces of a cube round the camera.",
    .cost = "a choice among six a pixel",
    .field = {6.0, 6.0, 6.0, false, 6.0, 6.0},  // three faces
    .direction =
        [](ImagePlace at) {
            const CubeFace& face = kCubeFaceAxes[cube_face_at(at)];
            const ImagePlace in = within_cube_face(at);
            return in.u * face.right + in.v * face.up + face.ahead;
        },
    .place =
        [](Vec3 d) {
            int face = 0;
            for (int i = 1; i < kFacesOfCube; ++i)
                if (dot(d, kCubeFaceAxes[i].ahead) > dot(d, kCubeFaceAxes[face].ahead)) face = i;
            return cube_face_place(face, d);
        },
    .area = [](ImagePlace at) { return pinhole_area(within_cube_face(at)); },
    .angle = [](double pixel, ImagePlace at) { return pinhole_angle(pixel, within_cube_face(at)); },
    .aside = [](double, double, double) { return M_PI; },
    .shown = [](double) { return 2.0; },
    .faces = true,
};

}  // namespace nullscope
