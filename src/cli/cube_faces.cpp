#include "cli/cube_faces.h"

#include <fmt/format.h>

#include "observer/pose.h"
#include "scene/projection.h"

namespace nullscope::cli {
namespace {

constexpr std::string_view kPlace = "%s";

template <class T>
Image<T> cut(const Image<T>& all, int left, int top, int side) {
    if (all.empty()) return {};
    Image<T> face(side, side, all.channels);
    copy_part(all, left, top, side, side, face, 0, 0);
    return face;
}

}  // namespace

Status check_faces(const Scene& scene, const CaptureOptions& options) {
    if (!names_faces(options)) return Done{};
    const std::string what = fmt::format("-o {}: ", options.output);
    if (options.output.find(kPlace, options.output.find(kPlace) + 1) != std::string::npos ||
        options.output.find('/', options.output.find(kPlace)) != std::string::npos)
        return bad_input(what + "a face's name has one place", "one %s in the file's name");
    if (scene.camera.projection != Projection::kCube)
        return bad_input(what + "only cubes have faces", "a scene with camera.projection = \"cube\", or no %s");
    if (!options.frames.empty() || options.to_film())
        return bad_input(what + "faces are of one picture", "no --frames, or no %s");
    if (scene.camera.stereo != Stereo::kOff || !options.split.empty() || options.raydata || options.layers ||
        !options.st_map.empty())
        return bad_input(what + "faces are of one camera's colours",
                         "no camera.stereo, --split, --raydata, --layers and --st-map, or no %s");
    return Done{};
}

// Across a face directions are linear.
CameraSpec face_camera(const CameraSpec& camera, int face) {
    const int side = camera.width / 3, column = face % 3, row = face / 3;
    const double x = (column + 0.5) * side, y = (row + 0.5) * side, step = 0.25 * side;
    const Vec3 ahead = pixel_direction(camera, x, y);
    const Mat3 axes{normalized(pixel_direction(camera, x + step, y) - ahead),
                    normalized(pixel_direction(camera, x, y - step) - ahead), -ahead};
    CameraSpec seen = camera;
    seen.projection = Projection::kPinhole;
    seen.plane_width = 2.0, seen.focal_distance = 1.0;
    seen.width = seen.height = side;
    set_axes(seen, static_from_camera(camera) * axes);
    return seen;
}

Status write_faces(const PictureOrigin& origin, const Captured& captured, const CaptureOptions& options) {
    const Scene& scene = origin.scene;
    const int side = scene.camera.width / 3;
    for (int face = 0; face < 6; ++face) {
        const int left = face % 3 * side, top = face / 3 * side;
        Captured one;
        one.linear = cut(captured.linear, left, top, side);
        one.display = cut(captured.display, left, top, side);
        one.made_by = captured.made_by;
        PictureOrigin seen = origin;
        seen.scene.camera = face_camera(scene.camera, face);
        std::string name = options.output;
        name.replace(name.find(kPlace), kPlace.size(), kFaceNames[static_cast<std::size_t>(face)]);
        if (Status written = write_picture(name, seen, one, options); !written) return written;
    }
    return Done{};
}

}  // namespace nullscope::cli
