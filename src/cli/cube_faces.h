// The faces of a cube's picture as six files: -o NAME-%s.png.
#pragma once
#include <array>
#include <functional>
#include <string>

#include "base/result.h"
#include "cli/picture_file.h"
#include "scene/exposure.h"

namespace nullscope::cli {

// In the order of the picture, three columns and two rows. With x to the right, y up and z ahead these are the faces nx pz px ny nz py of a cube
// map in OpenGL, Vulkan and Direct3D, each the way up that they want it.
inline constexpr std::array<const char*, 6> kFaceNames = {"left", "front", "right", "down", "back", "up"};

inline bool names_faces(const CaptureOptions& options) { return options.output.find("%s") != std::string::npos; }
// Errors: bad input, where -o names faces.
Status check_faces(const Scene& scene, const CaptureOptions& options);

// The pinhole camera of 90 degrees whose picture that face is. camera: of a cube.
CameraSpec face_camera(const CameraSpec& camera, int face);

// Draws each face by its camera, so that its file draws it again, and writes it. draw: what that camera sees. origin: of a picture of all faces.
// Returns what the last was made by.
using DrawFace = std::function<Result<Captured>(const Exposure& shown)>;
Result<std::string> draw_faces(const PictureOrigin& origin, const Exposure& shown, const CaptureOptions& options,
                               const DrawFace& draw);

}  // namespace nullscope::cli
