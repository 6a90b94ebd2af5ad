#include "cli/cube_faces.h"

#include <fmt/format.h>

#include "observer/pose.h"
#include "scene/projection.h"

namespace nullscope::cli {
namespace {

constexpr std::string_view kPlace = "%s";

}  // namespace

Status check_faces(const Scene& scene, const CaptureOptions& options) {
    if (!names_faces(options)) return Done{};
    const std::string what = fmt::format("-o {}: ", options.output);
    if (options.output.find(kPlace, options.output.find(kPlace) + 1) != std::string::npos ||
        options.output.find('/', options.output.find(kPlace)) != std::string::npos)
        return bad_input(what + "names of faces need one placeholder", "one %s in the file's name");
    if (!projection_of(scene.camera).faces)
        return bad_input(what + "only cubes have faces", "a scene with camera.projection = \"cube\", or no %s");
    if (!options.frames.empty() || options.to_film())
        return bad_input(what + "faces are for one picture only", "no --frames, or no %s");
    if (scene.picture.auto_exposure)
        return bad_input(what + "each face would have its own exposure", "picture.auto_exposure = \"off\", or no %s");
    if (scene.path && scene.picture.shutter > 0.0)
        return bad_input(what + "a face's file records one camera, but picture.shutter averages several of a [path]",
                         "a scene without one of both, or no %s");
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

Result<std::string> draw_faces(const PictureOrigin& origin, const Exposure& shown, const CaptureOptions& options,
                               const DrawFace& draw) {
    std::string made_by;
    for (int face = 0; face < kFacesOfCube; ++face) {
        const auto seen_by = [&](Scene scene) {
            scene.camera = face_camera(scene.camera, face);
            return scene;
        };
        TRY(captured, draw(changed(shown, seen_by)));
        PictureOrigin seen = origin;
        seen.scene = seen_by(origin.scene);
        std::string name = options.output;
        name.replace(name.find(kPlace), kPlace.size(), kFaceNames[static_cast<std::size_t>(face)]);
        TRY(written, write_picture(name, seen, *captured, options));
        made_by = captured->made_by;
    }
    return made_by;
}

}  // namespace nullscope::cli
