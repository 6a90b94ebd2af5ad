// What the program asks of a projection: one row, a file each (projection_pinhole.h, ...); CONTRIBUTING.md has the recipe. What of it runs on
// the GPU is shaders/projection/NAME.glsl. Headers alone: src/coretexts reads the rows before anything is linked.
#pragma once
#include <cmath>
#include <optional>
#include <string_view>

#include "base/vec.h"

namespace nullscope {

// In the image plane, right and up of the line of sight: px of a pixel's height times CameraSpec::pixel(), 1 rad in the middle.
struct ImagePlace {
    double u, v;
};

// Horizontal, of the whole picture, rad.
struct FieldOfView {
    double usual;                        // unless a scene says otherwise
    double least, most;                  // of scene files; least = 0 is not allowed itself
    bool below = false;                  // nor is most
    double steered_least, steered_most;  // by the viewer
    constexpr bool contains(double angle) const {
        constexpr double kRounding = 1e-12;  // of degrees
        return angle > 0.0 && angle >= (1.0 - kRounding) * least && (below ? angle < most : angle <= most);
    }
};
constexpr double rad(double degrees) { return degrees * M_PI / 180.0; }
inline constexpr FieldOfView kFieldAllRound{rad(360), rad(10), rad(360), false, rad(10), rad(360)};

struct ProjectionRow {
    std::string_view name;  // of camera.projection
    std::string_view is;    // for that key's help; "" where the name says it
    // Key of the effect, its define in shaders, help and cost: EffectRow's. The pinhole is none.
    std::string_view effect, define, help, cost;
    FieldOfView field;
    // To the right, up and backward, of any length.
    Vec3 (*direction)(ImagePlace at);
    // Of a direction of any length; nothing where it is not seen. Of several places the one nearest to the line of sight.
    std::optional<ImagePlace> (*place)(Vec3 direction);
    // Solid angle for an area of 1, sr.
    double (*area)(ImagePlace at);
    // That a pixel spans, rad, to count errors in: the square root of its solid angle; where pixels become narrow strips still `pixel`, as in
    // the middle.
    double (*angle)(double pixel, ImagePlace at);
    // From the line of sight, rad, at most. right, up: px from there to the picture's sides.
    double (*aside)(double right, double up, double pixel);
    // How wide the image is across a field of view, and back. nullptr: as wide as that.
    double (*width)(double angle) = nullptr;
    double (*field_of_width)(double width) = nullptr;
    // How far from the line of sight it shows anything, as places. nullptr: everywhere.
    double (*shown)(double field) = nullptr;
    // A plane's picture: has plane_width and focal_distance, [zoom] and [split], and nothing that is behind the camera.
    bool flat = false;
    bool circle = false;  // it shows a circle, whose diameter is the smaller side and spans the field of view
    bool round = false;   // columns come round again after 2 pi
    // Six square faces in three columns and two rows, without field of view, shift and pixel aspect.
    bool faces = false;
    double mesh_aspect = 0.0;  // width over height of the picture that a mesh takes; 0: the screen's
    // Code of the World Coordinate System of FITS, of zenithal projections; its comment.
    std::string_view fits = {}, fits_is = {};
};

// sin(angle)/angle
inline double sinc(double angle) { return angle == 0.0 ? 1.0 : std::sin(angle) / angle; }

}  // namespace nullscope
