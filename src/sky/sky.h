// The celestial sphere as a cube map on the host: drawn from the star catalogue and the Milky Way map that ship, or resampled
// from an image. The reference samples it; render uploads the same rows, packed (sky/packed_sky.h): content is shared, geodesics are not.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "image/image.h"
#include "scene/scene.h"
#include "sky/cube.h"

namespace nullscope {

class SkyPainter;

// Faces in OpenGL's order +x -x +y -y +z -z and orientation (OpenGL 3.3 core, table 3.19), linear RGB, size x size each.
// Axes: the world's (z = north pole of the hole's coordinates); sky rotation of SkySpec is already applied.
struct SkyCube {
    int size = 0;
    std::array<Image<float>, 6> faces;
    std::vector<std::string> notes;  // what was done to images that are finer than the faces can show, a line each
};

// face_size: power of two, 16 ... 8192. Parallel; about 0.5 s for 2048 on two cores. Deterministic.
// Errors: image missing, not an image, asset missing.
Result<SkyCube> build_sky(const SkySpec& spec, const std::filesystem::path& assets, int face_size);

// The same of a sky that is ready to be painted. Without a border.
SkyCube painted_sky(const SkyPainter& painter);

// world_from_sky = R_z(yaw) R_x(tilt).
Mat3 sky_rotation(const SkySpec& spec);

// Bilinear within a face at the finest level. direction: any length > 0.
Vec3 sample_sky(const SkyCube& sky, Vec3 direction);

}  // namespace nullscope
