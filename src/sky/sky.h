// The celestial sphere as a cube map on the host: drawn from the star catalogue and the Milky Way map that ship, or resampled
// from an image. render uploads it, the reference samples it: content is shared, geodesics are not.
#pragma once
#include <array>
#include <bit>
#include <filesystem>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/result.h"
#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

// Faces in OpenGL's order +x -x +y -y +z -z and orientation (OpenGL 3.3 core, table 3.19), linear RGB, size x size each.
// Axes: the world's (z = north pole of the hole's coordinates); sky rotation of SkySpec is already applied.
struct SkyCube {
    int size = 0;
    std::array<Image<float>, 6> faces;
    std::vector<std::string> notes;   // what was done to images that are finer than the faces can show, a line each
};

// face_size: power of two, 16 ... 8192. Parallel; about 0.5 s for 2048 on two cores. Deterministic.
// Errors: image missing, not an image, asset missing.
Result<SkyCube> build_sky(const SkySpec& spec, const std::filesystem::path& assets, int face_size);

// The same faces with what lies beside them on every side, for textures that are no cube maps (shaders/object/celestial_sphere.glsl).
// Of kBorderOf texels of a face one on each side is border: half a texel of the level of 16 texels, the coarsest that is filtered
// without a seam. sky.size: at least kBorderOf.
inline constexpr int kBorderOf = 32;
inline int bordered_size(int face_size) { return face_size + 2 * (face_size / kBorderOf); }
inline int bordered_levels(int face_size) { return std::bit_width(static_cast<unsigned>(face_size / kBorderOf)) + 1; }
SkyCube with_borders(const SkyCube& sky);

// world_from_sky = R_z(yaw) R_x(tilt).
Mat3 sky_rotation(const SkySpec& spec);

// Bilinear within a face at the finest level. direction: any length > 0.
Vec3 sample_sky(const SkyCube& sky, Vec3 direction);

// Direction through texel position (u, v) in [0,1]^2 of a face, not normalised; and the face and position of a direction.
Vec3 cube_direction(int face, double u, double v);
struct CubePosition { int face; double u, v; };
CubePosition cube_position(Vec3 direction);

}  // namespace nullscope
