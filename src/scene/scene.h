// Scene: plain data that says what is there. Units inside: lengths in r_s, angles in rad, speeds in c, r_s = c = 1.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace nullscope {

struct SpacetimeSpec {
    std::string metric = "schwarzschild";      // a key of the registry in spacetime/registry.h
    std::map<std::string, double> parameters;  // by name, checked against the registry's ranges
    friend bool operator==(const SpacetimeSpec&, const SpacetimeSpec&) = default;
};

// How the one who holds the camera moves: scene/observer.h.
enum class ObserverKind { kStatic, kRain, kFall, kThrow, kOrbit, kZamo, kCarter, kCounterOrbit };

// A pinhole camera. The unrotated camera looks at the centre (forward = -e_r), up = -e_theta (towards the north pole),
// right = forward x up = e_phi... see camera/pose.h. yaw turns to the right, then pitch turns up, then roll turns the picture's
// top to the right.
struct CameraSpec {
    double r = 15.0;      // > 0, outside the horizon for a static camera
    double theta = 1.48;  // polar angle, [0, pi]
    double phi = 0.0;  // azimuth; about a rotating hole, of an observer that falls, the one of spacetime/spin_frame.h
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
    ObserverKind observer = ObserverKind::kStatic;
    double fall_from = 1e6;  // kFall: radius of rest, r_s
    double energy = 1.0;     // kThrow: per rest mass, > 0
    Vec3 velocity{0, 0, 0};  // of the camera in the observer's frame, components along (e_r, e_theta, e_phi), |v| < 1
    double plane_width = 1.1547005383792517;  // width of the projection plane ...
    double focal_distance = 1.0;     // ... and its distance: fov = 2 atan(plane_width / 2 focal_distance), 60 degrees
    int width = 1280, height = 720;  // pixels, square
    double exposure_ev = 0.0;        // display brightness is multiplied by 2^exposure_ev
    friend bool operator==(const CameraSpec&, const CameraSpec&) = default;
};

// What a solid body, a disc or a sky looks like. Procedural kinds give a number from 0 to 1 at every place, which mixes two colours.
enum class TextureKind { kPlain, kChecker, kGrid, kStripes, kNoise, kFormula, kImage };
// How the unit square of texture coordinates (u, v), v from the top, covers directions from a body's middle (azimuth grows to
// the right as seen from outside):
// kEquirectangular: u azimuth, v polar angle. kBand: u azimuth, v latitude from +band to -band; beyond it the second colour.
// kCaps: left half the northern, right half the southern hemisphere, azimuthal equidistant, the pole in the middle of each.
// kCubeFaces: three columns and two rows of faces: +x -x +y above -y +z -z.
enum class BodyMapping { kEquirectangular, kBand, kCaps, kCubeFaces };
struct BodyLook {
    TextureKind texture = TextureKind::kPlain;
    BodyMapping mapping =
        BodyMapping::kEquirectangular;  // not of the cylinder: its square covers [-outer, outer]^2, as the disc's
    std::filesystem::path image{};      // kImage
    std::string formula{};              // kFormula: of u, v, x, y, z (docs/expressions.md)
    Vec3 colour{1.0, 0.72, 0.42}, second_colour{0.12, 0.05, 0.03};  // linear light; kImage is multiplied by colour
    int columns = 24, rows = 12;                // of the pattern over u and over v; of noise: grains across the radius
    double band_latitude = 1.0471975511965976;  // kBand, (0, pi/2]
    double rotation = 0.0;                      // of the look about the polar axis
    double limb = 0.0;                          // light times 1 - limb (1 - cosine of the angle to the normal), [0, 1]
    double brightness = 1.0;
    friend bool operator==(const BodyLook&, const BodyLook&) = default;
};

// kStars: the catalogue drawn into a picture of the sky. kPoints: its stars as points, over the Milky Way. From kPlain on: SkySpec::look,
// of the TextureKind of the same name.
enum class SkyKind { kStars, kImage, kBlack, kPoints, kPlain, kChecker, kGrid, kStripes, kNoise, kFormula };
inline constexpr const char* kSkyKindNames[] = {"stars",   "image", "black",   "points", "plain",
                                                "checker", "grid",  "stripes", "noise",  "formula"};
inline bool has_look(SkyKind kind) { return kind >= SkyKind::kPlain; }
enum class SkyMapping { kEquirectangular, kBandAndCaps };

// The celestial sphere at infinity.
// kEquirectangular: column = azimuth (phi = 0 in the middle, growing to the left as seen from inside), row = polar angle.
// kBandAndCaps (the slides' mapping): band image around the equator for |latitude| <= band_latitude, columns = azimuth,
// rows = latitude; two azimuthal (equidistant) images for the caps, pole in the middle, the cap's edge on the inscribed circle.
struct SkySpec {
    SkyKind kind = SkyKind::kStars;
    SkyMapping mapping = SkyMapping::kEquirectangular;
    std::filesystem::path image;                 // equirectangular, or the band
    std::filesystem::path north_cap, south_cap;  // kBandAndCaps only
    double band_latitude = 0.7853981633974483;   // kBandAndCaps only, (0, pi/2)
    double yaw = 0.0, tilt = 0.0;                // world_from_sky = R_z(yaw) R_x(tilt)
    double brightness = 1.0;
    std::optional<double>
        temperature_K;       // of the black body for which its light is taken where g changes it; else g does not
    double faintest = 20.0;  // kPoints only: magnitude V of the faintest stars
    int even_stars = 0;      // kPoints only; above 0: so many equal stars, evenly spread, and no catalogue
    // has_look(kind) only; colours, formula, columns and rows of it alone. u = 1/2 - azimuth/turn and v = polar angle/half turn of the
    // sky's own axes, as the columns and rows of an equirectangular image; x, y, z: the unit vector there.
    BodyLook look{.colour = {0.5, 0.75, 1.0}, .second_colour = {0.01, 0.015, 0.03}};
    friend bool operator==(const SkySpec&, const SkySpec&) = default;
};

// The look of a sky that has one: its texture is the kind's.
inline BodyLook sky_look(const SkySpec& sky) {
    BodyLook look = sky.look;
    look.texture = has_look(sky.kind)
                       ? static_cast<TextureKind>(static_cast<int>(sky.kind) - static_cast<int>(SkyKind::kPlain))
                       : TextureKind::kPlain;
    return look;
}

// A flat disc in the equatorial plane theta = pi/2, visible from both sides. The image is mapped affinely: its square
// [0,1]^2 covers [-outer, outer]^2 in the disc's (x, y), rotated by `rotation`; image row 0 is y = +outer.
// kImage: the light of image or texture as it is. kThermal: heat by Page and Thorne, on which these act as an emissivity.
enum class DiscEmission { kImage, kThermal };

// What heats a thermal disc. Rates in L_Eddington/(0.1 c^2), L_Eddington = 4 pi G M m_p c/sigma_T.
struct AccretionSpec {
    double mass_suns = 1e8, rate_eddington = 0.1;
    friend bool operator==(const AccretionSpec&, const AccretionSpec&) = default;
};

// How the pattern of a disc moves: not at all, or every ring as matter on circles does (docs/time.md).
enum class DiscFlowKind { kStill, kKepler };

struct DiscSpec {
    double inner = 3.0, outer = 12.0;  // 0 < inner < outer
    std::filesystem::path image;       // empty: the disc image that ships
    double opacity = 1.0;              // (0, 1]; below 1 what lies behind shines through
    double edge = 0.0;                 // fade of opacity at both rims, as a fraction of (outer - inner), [0, 0.5]
    double rotation = 0.0;
    double brightness = 1.0;
    DiscEmission emission = DiscEmission::kImage;
    double temperature_K = 8000.0;           // thermal: of the hottest ring, in its own frame; without `accretion`
    std::optional<AccretionSpec> accretion;  // thermal: gives the temperature
    DiscFlowKind flow = DiscFlowKind::kStill;
    int passed = 0;  // of each ray's crossings of the plane, before it is met: ray files list them one by one
    double flow_life =
        40.0;  // kKepler: a copy of the pattern is wound up this long, r_s/c, then it has faded into the next
    // Colours, formula, columns and rows of it alone, and none of these with texture kImage, which is `image`. u = 1/2 + azimuth/turn,
    // v = (r - inner)/(outer - inner); x, y: the place, z = 0.
    BodyLook look{.texture = TextureKind::kImage};
    friend bool operator==(const DiscSpec&, const DiscSpec&) = default;
};

// Hot spots in the disc, evenly spread over one circular orbit: Gaussian in distance, shining by heat whatever is behind, each moving as
// its middle does.
struct SpotSpec {
    double r = 3.5;           // of the orbit, outside the photon sphere
    double phase = 0.0;       // azimuth at time 0
    double size = 0.35;       // standard deviation
    double brightness = 1.0;  // in its middle, of a black body of its temperature
    double temperature_K = 8000.0;
    int count = 1;
    friend bool operator==(const SpotSpec&, const SpotSpec&) = default;
};

// Solid bodies: opaque, a ray ends on the first. Lengths in r_s; (r, theta, phi) are taken as flat spherical coordinates; of wormholes
// (|l|, theta, phi) of one side of the throat, which is the centre: far, l < 0.
struct SphereSpec {        // about the centre
    double radius = 3.0;   // outside the horizon
    double swing = 0.0;    // pulsation: radius (1 + swing sin(2 pi t/period)), [0, 0.5]
    double period = 40.0;  // r_s/c
    BodyLook look;
    friend bool operator==(const SphereSpec&, const SphereSpec&) = default;
};
struct CylinderSpec {  // about the polar axis: a disc of finite thickness, |z| <= height, inner <= rho <= outer
    double inner = 3.0, outer = 8.0, height = 0.5;
    bool far = false;
    BodyLook look;
    friend bool operator==(const CylinderSpec&, const CylinderSpec&) = default;
};
// kOrbit: on a circular geodesic through `position`, eastward. kGeodesic: falls freely, at t = 0 from `position` with `velocity` there.
// kPath: along formulas of t.
enum class BallMotion { kStill, kOrbit, kGeodesic, kPath };
struct BallSpec {  // a sphere anywhere
    Vec3 position{-12.0, 0.0, 0.0};
    double radius = 2.0;
    bool far = false;
    BallMotion motion = BallMotion::kStill;
    Vec3 velocity{0, 0, 0};  // kGeodesic: along (e_r, e_theta, e_phi) of one at rest there, |v| < 1
    std::string x, y, z;     // kPath: docs/expressions.md, of t in r_s/c
    BodyLook look;
    friend bool operator==(const BallSpec&, const BallSpec&) = default;
};

// kFormula: `shape`; the others are named_surface.h's, `size` long.
enum class SurfaceKind { kFormula, kTorus, kEllipsoid, kCube, kOctahedron, kHeart, kGyroid, kClebsch };
struct SurfaceSpec {  // the solid f(x, y, z, t) < 0, as far as `bound` from the centre; t: Scene::time
    SurfaceKind kind = SurfaceKind::kFormula;
    double size = 6.0;                                     // of a named surface
    std::string shape = "(length(x, y) - 6)^2 + z^2 - 2";  // f: docs/expressions.md
    double bound = 10.0;
    int steps = 64;  // steps across the bounding sphere: what is thinner than one may be missed
    bool far = false;
    BodyLook look;
    friend bool operator==(const SurfaceSpec&, const SurfaceSpec&) = default;
};
// What is seen through a wormhole: the same stars, turned, unless a scene says otherwise.
inline SkySpec default_far_sky() {
    SkySpec sky;
    sky.yaw = 2.0943951023931953;   // 120 degrees
    sky.tilt = 1.5707963267948966;  // 90 degrees
    return sky;
}

// What light does on its way, each to be switched off alone, to teach with.
struct LightSpec {
    bool shift = true;        // of colour
    bool beaming = true;      // of brightness
    bool bolometric = false;  // brightness is power at all wavelengths, as T^4, not luminance
    // The two parts of g, as static observers at the matter and at the camera split it (docs/light.md); and directions.
    bool doppler = true;     // motion of matter and camera changes frequencies
    bool gravity = true;     // so does the way out of gravity
    bool aberration = true;  // a moving camera sees other directions
    bool delay = true;       // light takes time: what moves is seen where it was
    bool lensing = true;  // light follows the metric's geodesics; else straight lines in flat space, all else as it is
    friend bool operator==(const LightSpec&, const LightSpec&) = default;
};

// What becomes of a picture's light before a display shows it. EXR files hold it as it is.
enum class ToneCurve { kShoulder, kFilm, kNeutral };  // 1 - exp(-x); a fit of ACES; Khronos' neutral one
struct PictureSpec {
    ToneCurve tone = ToneCurve::kShoulder;
    double bloom = 0.0;          // share of the light that lens and eye scatter, [0, 1)
    bool auto_exposure = false;  // CameraSpec::exposure_ev then adds to what the picture's mean luminance asks for
    bool dither = false;         // noise of half a step of 8 bits against bands
    friend bool operator==(const PictureSpec&, const PictureSpec&) = default;
};

// Where the camera goes from frame to frame. kFall: let go at frame 0, in equal steps of its own time; axes are gyroscopes, or turned to
// look at the centre. kKeys: smooth through keys.
enum class PathKind { kFall, kKeys };
enum class PathLook { kGyroscope, kCentre };
struct PathKey {
    double frame = 0.0;
    CameraSpec camera;
};
struct PathSpec {
    PathKind kind = PathKind::kFall;
    PathLook look = PathLook::kGyroscope;
    int frames = 240;
    double rate = 24.0;  // frames a second of film
    double duration =
        0.0;  // kFall: proper time from the first frame to the last, r_s/c; 0: to the end of the worldline
    std::vector<PathKey> keys;  // kKeys: two or more, frames growing
};

struct Scene {
    std::string name, description;
    SpacetimeSpec spacetime;
    std::optional<SpacetimeSpec>
        beside;                // split screen (scene/split.h): the right half shows the same in this spacetime
    bool beside_delay = true;  // and whether light takes time there
    CameraSpec camera;
    SkySpec sky;
    SkySpec far_sky = default_far_sky();  // of wormholes: at l = -infinity
    std::optional<DiscSpec> disc;
    std::optional<SpotSpec> spot;
    std::optional<SphereSpec> sphere;
    std::optional<CylinderSpec> cylinder;
    std::optional<BallSpec> ball;
    std::optional<SurfaceSpec> surface;
    LightSpec light;
    PictureSpec picture;
    std::optional<PathSpec> path;
    // r_s/c: t of the camera, by the clocks at infinity; of a camera that falls v - r, v = t + r_*, which is regular on the horizon.
    double time = 0.0;
};

}  // namespace nullscope
