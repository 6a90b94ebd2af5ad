// The faces of a cube's picture as six files: -o NAME-%s.png.
#pragma once
#include <array>
#include <string>

#include "base/result.h"
#include "cli/picture_file.h"

namespace nullscope::cli {

// In the order of the picture, three columns and two rows. With x to the right, y up and z ahead these are the faces nx pz px ny nz py of a cube
// map in OpenGL, Vulkan and Direct3D, each the way up that they want it.
inline constexpr std::array<const char*, 6> kFaceNames = {"left", "front", "right", "down", "back", "up"};

inline bool names_faces(const CaptureOptions& options) { return options.output.find("%s") != std::string::npos; }
// Errors: bad input, where -o names faces.
Status check_faces(const Scene& scene, const CaptureOptions& options);

// The pinhole camera of 90 degrees whose picture that face is. camera: of a cube.
CameraSpec face_camera(const CameraSpec& camera, int face);

// Cuts captured, the picture of all faces, into files. origin: of that picture.
Status write_faces(const PictureOrigin& origin, const Captured& captured, const CaptureOptions& options);

}  // namespace nullscope::cli
