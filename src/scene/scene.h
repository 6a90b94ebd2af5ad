// Scene: plain data that says what is there. Units inside: lengths in r_s, angles in rad, speeds in c, r_s = c = 1.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/vec.h"

namespace nullscope {

struct SpacetimeSpec {
    std::string metric = "schwarzschild";       // a key of the registry in spacetime/registry.h
    std::map<std::string, double> parameters;   // by name, checked against the registry's ranges
    friend bool operator==(const SpacetimeSpec&, const SpacetimeSpec&) = default;
};

// A pinhole camera. The unrotated camera looks at the centre (forward = -e_r), up = -e_theta (towards the north pole),
// right = forward x up = e_phi... see camera/pose.h. yaw turns to the right, then pitch turns up, then roll turns the picture's
// top to the right.
struct CameraSpec {
    double r = 15.0;                 // > 0, outside the horizon for a static camera
    double theta = 1.48;             // polar angle, [0, pi]
    double phi = 0.0;                // azimuth
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
    Vec3 velocity{0, 0, 0};          // of the camera in the static frame, components along (e_r, e_theta, e_phi), |v| < 1
    double plane_width = 1.1547005383792517;  // width of the projection plane ...
    double focal_distance = 1.0;     // ... and its distance: fov = 2 atan(plane_width / 2 focal_distance), 60 degrees
    int width = 1280, height = 720;  // pixels, square
    double exposure_ev = 0.0;        // display brightness is multiplied by 2^exposure_ev
};

enum class SkyKind { kStars, kImage, kBlack };
enum class SkyMapping { kEquirectangular, kBandAndCaps };

// The celestial sphere at infinity.
// kEquirectangular: column = azimuth (phi = 0 in the middle, growing to the left as seen from inside), row = polar angle.
// kBandAndCaps (the slides' mapping): band image around the equator for |latitude| <= band_latitude, columns = azimuth,
// rows = latitude; two azimuthal (equidistant) images for the caps, pole in the middle, the cap's edge on the inscribed circle.
struct SkySpec {
    SkyKind kind = SkyKind::kStars;
    SkyMapping mapping = SkyMapping::kEquirectangular;
    std::filesystem::path image;                          // equirectangular, or the band
    std::filesystem::path north_cap, south_cap;           // kBandAndCaps only
    double band_latitude = 0.7853981633974483;            // kBandAndCaps only, (0, pi/2)
    double yaw = 0.0, tilt = 0.0;                         // world_from_sky = R_z(yaw) R_x(tilt)
    double brightness = 1.0;
    friend bool operator==(const SkySpec&, const SkySpec&) = default;
};

// A flat disc in the equatorial plane theta = pi/2, visible from both sides. The image is mapped affinely: its square
// [0,1]^2 covers [-outer, outer]^2 in the disc's (x, y), rotated by `rotation`; image row 0 is y = +outer.
// kImage: the image's light as it is. kThermal: heat by Page and Thorne, on which an image acts as an emissivity.
enum class DiscEmission { kImage, kThermal };

struct DiscSpec {
    double inner = 3.0, outer = 12.0;   // 0 < inner < outer
    std::filesystem::path image;        // empty: the disc image that ships
    double opacity = 1.0;               // (0, 1]; below 1 what lies behind shines through
    double edge = 0.0;                  // fade of opacity at both rims, as a fraction of (outer - inner), [0, 0.5]
    double rotation = 0.0;
    double brightness = 1.0;
    DiscEmission emission = DiscEmission::kImage;
    double temperature_K = 8000.0;      // thermal: of the hottest ring, in its own frame
    friend bool operator==(const DiscSpec&, const DiscSpec&) = default;
};

// What light does on its way, each to be switched off alone, to teach with.
struct LightSpec {
    bool shift = true;     // of colour
    bool beaming = true;   // of brightness
    friend bool operator==(const LightSpec&, const LightSpec&) = default;
};

struct Scene {
    std::string name, description;
    SpacetimeSpec spacetime;
    CameraSpec camera;
    SkySpec sky;
    std::optional<DiscSpec> disc;
    LightSpec light;
};

}  // namespace nullscope
