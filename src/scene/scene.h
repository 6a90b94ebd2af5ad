// Scene: plain data that describes what is there. Units: lengths in r_s, angles in rad, speeds in c, r_s = c = 1.
#pragma once
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vec.h"
#include "scene/disc_heat_spec.h"
#include "scene/disc_plane.h"
#include "scene/disc_warp.h"
#include "scene/known_object.h"
#include "scene/medium_spec.h"
#include "scene/polarisation_spec.h"
#include "scene/projection_kind.h"
#include "scene/sphere_spec.h"
#include "spacetime/metric_parameters.h"

namespace nullscope {

struct SpacetimeSpec {
    std::string metric = "schwarzschild";  // a key of the registry in spacetime/registry.h
    MetricParameters parameters;           // by name, numbers checked against the registry's ranges
    friend bool operator==(const SpacetimeSpec&, const SpacetimeSpec&) = default;
};

// Motion of the observer (observer/observer.h).
enum class ObserverKind { kStatic, kRain, kFall, kThrow, kOrbit, kZamo, kCarter, kCounterOrbit };

// A zoom towards the photon ring: the picture's middle lies on the critical curve, exactly, and its directions are exp(-depth) as wide
// as the camera's field of view (observer/ring_view.h).
struct ZoomSpec {
    double depth = 0.0;  // ln of the magnification, >= 0
    double angle = 0.0;  // along the ring, CriticalLight's psi: 0 is left of the hole, pi/2 above it
    friend bool operator==(const ZoomSpec&, const ZoomSpec&) = default;
};

// Pictures for two eyes, which lie eye_distance apart along the camera's right axis and look the same way (scene/stereo.h). kPair: two
// pictures side by side, the left eye's first. kAllRound: omnidirectional stereo, of equirectangular pictures: in every column the eyes
// lie across that column's direction; the left eye's picture is above the right one's.
enum class Stereo { kOff, kPair, kAllRound };
inline constexpr const char* kStereoNames[] = {"off", "pair", "all-round"};

// Of a picture that is drawn in parts: where a part begins, px from the upper left corner, and the size of the whole.
struct PicturePart {
    int left = 0, top = 0, width = 0, height = 0;
    friend bool operator==(const PicturePart&, const PicturePart&) = default;
};

// A camera. The unrotated camera looks at the centre (forward = -e_r), up = -e_theta (towards the north pole),
// right = forward x up (observer/pose.h). yaw turns to the right, then pitch turns up, then roll turns the picture's top to
// the right.
// What a warp mesh's intensities are factors on: light, or the values of a display, whose light is their power of 2.2.
enum class WarpIntensity { kLinear, kDisplay };

struct CameraSpec {
    double r = 15.0;      // > 0, outside the horizon for a static camera
    double theta = 1.48;  // polar angle, [0, pi]
    double phi = 0.0;     // azimuth; of falling observers about a rotating hole the ingoing one (observer/spin_frame.h)
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
    ObserverKind observer = ObserverKind::kStatic;
    double fall_from = 1e6;  // kFall: radius of rest, r_s
    double energy = 1.0;     // kThrow: per rest mass, > 0
    Vec3 velocity{0, 0, 0};  // of the camera in the observer's frame, components along (e_r, e_theta, e_phi), |v| < 1
    Projection projection = Projection::kPinhole;  // how directions are laid out in the picture (scene/projection.h)
    // Pinhole: width of the projection plane and its distance, fov = 2 atan(plane_width / 2 focal_distance), 60 degrees. Others: the
    // angle that the picture spans, rad, across its width, of a fisheye across its smaller side; and 1. Cube: 6, three faces, and 1.
    double plane_width = 1.1547005383792517;
    double focal_distance = 1.0;
    double shift_x = 0.0, shift_y = 0.0;  // the picture's middle off the line of sight, right and up, of its size
    int width = 1280, height = 720;       // pixels ...
    double pixel_aspect = 1.0;            // ... and the width of one over its height
    double exposure_ev = 0.0;             // display brightness is multiplied by 2^exposure
    Stereo stereo = Stereo::kOff;
    double eye_distance = 0.1;     // r_s
    std::filesystem::path warp{};  // mesh that lays the projection's picture out anew (scene/warp_mesh.h); empty: none
    WarpIntensity warp_intensity = WarpIntensity::kLinear;
    std::optional<ZoomSpec> zoom{};     // then yaw and pitch follow from it
    std::optional<PicturePart> part{};  // of a larger picture, whose width plane_width spans
    int whole_width() const { return part ? part->width : width; }
    int whole_height() const { return part ? part->height : height; }
    // Tangent, of other projections than the pinhole angle, of the height of one in the middle, in a zoom too; 0 from a depth of some 700 on.
    double pixel() const;
    friend bool operator==(const CameraSpec&, const CameraSpec&) = default;
};

// An image file, and which of its pictures.
struct ImageSource {
    std::filesystem::path file{};
    std::string layer{};  // of an EXR with several; empty: the file's own
    friend auto operator<=>(const ImageSource&, const ImageSource&) = default;  // NOLINT(modernize-use-nullptr)
};

// Surface of a solid body, a disc or a sky. A procedural texture is a number from 0 to 1 at every point, which mixes two colours.
// kGas: of the disc only (GasSpec).
enum class TextureKind { kPlain, kChecker, kGrid, kStripes, kNoise, kFormula, kImage, kGas };
inline constexpr const char* kTextureNames[] = {"plain", "checker", "grid",  "stripes",
                                                "noise", "formula", "image", "gas"};
inline const char* texture_name(TextureKind kind) { return kTextureNames[static_cast<int>(kind)]; }
// How the unit square of texture coordinates (u, v), v from the top, covers directions from a body's middle (azimuth grows to
// the right as seen from outside):
// kEquirectangular: u azimuth, v polar angle. kBand: u azimuth, v latitude from +band to -band; beyond it the second colour.
// kCaps: left half the northern, right half the southern hemisphere, azimuthal equidistant, the pole in the middle of each.
// kCubeFaces: three columns and two rows of faces: +x -x +y above -y +z -z.
enum class BodyMapping { kEquirectangular, kBand, kCaps, kCubeFaces };
struct Material {
    TextureKind texture = TextureKind::kPlain;
    // Not of the cylinder: its square covers [-outer, outer]^2, as the disc's.
    BodyMapping mapping = BodyMapping::kEquirectangular;
    std::filesystem::path image{};                                  // kImage
    std::string image_layer{};                                      // of an EXR with several pictures; empty: its own
    std::string formula{};                                          // kFormula: of u, v, x, y, z (docs/expressions.md)
    Vec3 colour{1.0, 0.72, 0.42}, second_colour{0.12, 0.05, 0.03};  // linear light; kImage is multiplied by colour
    int columns = 24, rows = 12;                // of the pattern over u and over v; of noise: grains across the radius
    double band_latitude = 1.0471975511965976;  // kBand, (0, pi/2]
    double rotation = 0.0;                      // of the material about the polar axis
    double limb = 0.0, brightness = 1.0;  // limb: light times 1 - limb (1 - cosine of the angle to the normal), [0, 1]
    // Of bodies: light of the side away from a far light source over that where it is overhead, [0, 1]; 1: it shines by itself. Where it is.
    double night = 1.0, sun_longitude = 0.0, sun_latitude = 0.0;  // rad, world axes
    std::optional<double> temperature_K{};  // of bodies: they shine as a black body; unset: whatever g is
    ImageSource source() const { return {image, image_layer}; }
    friend bool operator==(const Material&, const Material&) = default;
};

// kStars: the catalogue drawn into a picture of the sky. kPoints: its stars as points, over the Milky Way. kNebula: another
// place, by formula. From kPlain on: SkySpec::material, with the TextureKind of the same name.
enum class SkyKind { kStars, kImage, kBlack, kNebula, kPoints, kPlain, kChecker, kGrid, kStripes, kNoise, kFormula };
inline constexpr const char* kSkyKindNames[] = {"stars",   "image", "black",   "nebula", "points", "plain",
                                                "checker", "grid",  "stripes", "noise",  "formula"};
inline bool is_procedural(SkyKind kind) { return kind >= SkyKind::kPlain; }
// Whose stars kStars and kPoints show. kTycho2: to V = 10.5; its file is fetched by scripts/fetch_stars.py.
enum class StarCatalogue { kHipparcos, kTycho2 };
enum class SkyMapping { kEquirectangular, kBandAndCaps };

// A made emission nebula (sky/nebula.h): linear colours of its hydrogen and its oxygen.
struct NebulaSpec {
    int seed = 1;
    Vec3 hydrogen{1.0, 0.16, 0.20}, oxygen{0.10, 0.62, 0.66};
    friend bool operator==(const NebulaSpec&, const NebulaSpec&) = default;
};

// The celestial sphere at infinity.
// kEquirectangular: column = azimuth (phi = 0 in the middle, growing to the left as seen from inside), row = polar angle.
// kBandAndCaps (the slides' mapping): band image around the equator for |latitude| <= band_latitude, columns = azimuth,
// rows = latitude; two azimuthal (equidistant) images for the caps, pole in the middle, the cap's edge on the inscribed circle.
struct SkySpec {
    SkyKind kind = SkyKind::kStars;
    SkyMapping mapping = SkyMapping::kEquirectangular;
    std::filesystem::path image;                 // equirectangular, or the band
    std::filesystem::path north_cap, south_cap;  // kBandAndCaps only
    std::string image_layer{};                   // of EXR files with several pictures; empty: their own
    double band_latitude = 0.7853981633974483;   // kBandAndCaps only, (0, pi/2)
    double yaw = 0.0, tilt = 0.0;                // world_from_sky = R_z(yaw) R_x(tilt)
    double brightness = 1.0;
    std::optional<double>
        temperature_K;  // g shifts the sky's light as that of a black body of this temperature; unset: not at all
    StarCatalogue catalogue = StarCatalogue::kHipparcos;  // kStars and kPoints only
    double magnitude_limit = 20.0;                        // kPoints only: V of the faintest stars that are drawn
    int uniform_stars = 0;  // kPoints only; above 0: this many equal stars, uniformly spread, instead of the catalogue
    NebulaSpec nebula{};    // kNebula only
    // is_procedural(kind) only; only colours, formula, columns and rows are used. u = 1/2 - azimuth/2 pi and v = polar angle/pi
    // in the sky's own axes, as columns and rows of an equirectangular image; x, y, z: the unit vector in that direction.
    Material material{.colour = {0.5, 0.75, 1.0}, .second_colour = {0.01, 0.015, 0.03}};
    friend bool operator==(const SkySpec&, const SkySpec&) = default;
};

// The material of a procedural sky: its texture follows from the kind.
inline Material sky_material(const SkySpec& sky) {
    Material material = sky.material;
    material.texture = is_procedural(sky.kind)
                           ? static_cast<TextureKind>(static_cast<int>(sky.kind) - static_cast<int>(SkyKind::kPlain))
                           : TextureKind::kPlain;
    return material;
}

// A flat disc in a plane through the centre, the equatorial one if it does not lean, visible from both sides. The image is mapped affinely: its square
// [0,1]^2 covers [-outer, outer]^2 in the disc's (x, y), rotated by `rotation`; image row 0 is y = +outer.
// kImage: the light of image or texture as it is. kThermal: thermal emission, flux by DiscSpec::emissivity, which image or texture multiply.
enum class DiscEmission { kImage, kThermal };

struct DiscSpec {
    double inner = 3.0, outer = 12.0;  // 0 < inner < outer
    std::filesystem::path image{};     // empty: the disc image that ships
    std::string image_layer{};         // of an EXR with several pictures; empty: its own
    double opacity = 1.0;              // (0, 1]; below 1 what lies behind is visible
    double edge = 0.0;                 // fade of opacity at both rims, as a fraction of (outer - inner), [0, 0.5]
    double rotation = 0.0, brightness = 1.0;
    DiscEmission emission = DiscEmission::kImage;
    double temperature_K = 8000.0;             // thermal: of the hottest ring, in its own frame; without `accretion`
    std::optional<AccretionSpec> accretion{};  // thermal: gives the temperature
    DiscFlowKind flow = DiscFlowKind::kStill;
    OrbitSense sense = OrbitSense::kEastward;  // of its matter: thermal light and flow
    DiscLean lean{};                           // of its plane
    DiscWarp warp{};                           // from that plane, and its gaps
    double flow_life = 40.0;                   // kKepler, r_s/c: for which a copy of the pattern is sheared
    // Only colours, formula, columns and rows are used; with texture kImage the picture is `image`. u = 1/2 + azimuth/2 pi,
    // v = (r - inner)/(outer - inner); x, y: the point in the disc, z = 0.
    Material material{.texture = TextureKind::kImage};
    EmissivitySpec emissivity{};  // thermal
    GasSpec gas{};                // with texture kGas
    DiscEffects effects{};
    PolarisationSpec polarisation{};
    friend bool operator==(const DiscSpec&, const DiscSpec&) = default;
};

// Hot spots in the disc, evenly spaced along one circular orbit: a Gaussian brightness profile of black-body light, added to the disc's.
// Each moves rigidly with its centre.
struct SpotSpec {
    double r = 3.5;           // of the orbit, outside the photon sphere
    double phase = 0.0;       // azimuth at time 0
    double size = 0.35;       // standard deviation
    double brightness = 1.0;  // at its centre, relative to a black body of its temperature
    double temperature_K = 8000.0;
    int count = 1;
    OrbitSense sense = OrbitSense::kEastward;
    friend bool operator==(const SpotSpec&, const SpotSpec&) = default;
};

// Solid bodies: opaque, a ray ends on the first one it meets. Lengths in r_s, in flat coordinates: (r, theta, phi) as spherical ones; in
// wormholes (|l|, theta, phi) on one side of the throat, which is the centre; Body::far: l < 0. See plan/body_kind.h.
struct CylinderSpec {  // about the polar axis: a disc of finite thickness, |z| <= height, inner <= rho <= outer
    static constexpr std::string_view kName = "cylinder";
    double inner = 3.0, outer = 8.0, height = 0.5;
    friend bool operator==(const CylinderSpec&, const CylinderSpec&) = default;
};
// kOrbit: eastward on the circular geodesic through `position`. kGeodesic: in free fall, at t = 0 at `position` with `velocity`.
// kPath: given by formulas of t.
enum class BallMotion { kStill, kOrbit, kGeodesic, kPath };
struct BallSpec {  // a sphere anywhere
    static constexpr std::string_view kName = "ball";
    Vec3 position{-12.0, 0.0, 0.0};
    double radius = 2.0;
    BallMotion motion = BallMotion::kStill;
    Vec3 velocity{0, 0, 0};     // kGeodesic: along (e_r, e_theta, e_phi) of an observer at rest there, |v| < 1
    std::string x{}, y{}, z{};  // kPath: docs/expressions.md, of t in r_s/c
    OrbitSense sense = OrbitSense::kEastward;  // kOrbit
    bool moves() const { return motion != BallMotion::kStill; }
    friend bool operator==(const BallSpec&, const BallSpec&) = default;
};

// kFormula: given by `shape`; the others: named_surface.h, in units of `size`.
enum class SurfaceKind { kFormula, kTorus, kEllipsoid, kCube, kOctahedron, kHeart, kGyroid, kClebsch };
struct SurfaceSpec {  // the solid f(x, y, z, t) < 0 within `bound` of the centre; t: Scene::time
    static constexpr std::string_view kName = "surface";
    SurfaceKind kind = SurfaceKind::kFormula;
    double size = 6.0;                                     // of a named surface
    std::string shape = "(length(x, y) - 6)^2 + z^2 - 2";  // f: docs/expressions.md
    double bound = 10.0;
    int steps = 64;  // march steps across the bounding sphere; thinner parts may be missed
    friend bool operator==(const SurfaceSpec&, const SurfaceSpec&) = default;
};

using BodyShape = std::variant<SphereSpec, CylinderSpec, BallSpec, SurfaceSpec>;  // by number (ray.h)
struct Body {
    BodyShape shape;
    std::string name{};  // in ray data; empty: body_name() gives one
    bool far = false;    // of a wormhole's throat; not of spheres
    Material material{};
    friend bool operator==(const Body&, const Body&) = default;
};
inline constexpr std::size_t kMostBodies = 64, kMostSpots = 64;  // of a scene
// The sky at the other end of a wormhole: by default the same stars, rotated.
inline SkySpec default_far_sky() {
    SkySpec sky;
    sky.yaw = 2.0943951023931953;   // 120 degrees
    sky.tilt = 1.5707963267948966;  // 90 degrees
    return sky;
}

// Parts of light propagation; for teaching, each can be switched off alone.
struct LightSpec {
    bool shift = true;        // shift changes colour
    bool beaming = true;      // and brightness
    bool bolometric = false;  // brightness is power at all wavelengths (T^4), not luminance
    // The two parts into which static observers at matter and camera split g (docs/light.md); and directions.
    bool doppler = true;     // frequencies: motion of matter and camera
    bool gravity = true;     // frequencies: gravitational redshift
    bool aberration = true;  // directions: motion of the camera
    bool delay = true;       // light-travel time: moving things are seen where they were
    bool lensing = true;     // light follows the metric's geodesics; off: straight lines, all else unchanged
    friend bool operator==(const LightSpec&, const LightSpec&) = default;
};

// How linear light becomes a displayed picture. EXR files hold linear light.
enum class ToneCurve { kShoulder, kFilm, kNeutral };  // 1 - exp(-x); a fit of ACES; Khronos' neutral one
// What the bar over the displayed picture counts (annotate/annotations.h): M = r_s/2, r_s, or angles as seen from ObjectSpec.
enum class ScaleBar { kOff, kMass, kRadius, kAngle };
struct PictureSpec {
    ToneCurve tone = ToneCurve::kShoulder;
    double bloom = 0.0;          // share of the light that lens and eye scatter, [0, 1)
    bool auto_exposure = false;  // from the picture's mean luminance; CameraSpec::exposure_ev is added
    bool dither = false;         // noise of half an 8-bit step, against banding
    int samples = 1;             // a pixel is the mean of samples x samples rays
    bool refine = true;          // where samples is 1: pixels that differ much from a neighbour have more rays
    ScaleBar scale_bar = ScaleBar::kOff;
    bool ticks = false;        // along the electric vector of polarised light, over the displayed picture
    bool streamlines = false;  // likewise, a texture of lines
    // Axis of a linear polariser before the camera, rad from the picture's right towards up; unset: none.
    std::optional<double> polariser{};
    double shutter = 0.0;  // of films: share of a frame's time that gathers light, [0, 1], about the frame's own
    int sub_frames = 16;   // of which its light is then the mean
    friend bool operator==(const PictureSpec&, const PictureSpec&) = default;
};

// Path of the camera from frame to frame. kFall: free fall from frame 0 on, in equal steps of proper time; its axes are
// parallel-transported (kGyroscope), or turned to keep their angle to the centre. kKeys: a smooth curve through keys.
enum class PathKind { kFall, kKeys };
enum class PathOrientation { kGyroscope, kCentre };
enum class PathEasing { kNone, kSmooth };
enum class PathTurn { kAngles, kShortest };
struct PathKey {
    double frame = 0.0;
    CameraSpec camera;
    double time = 0.0;             // later than Scene::time, r_s/c
    std::vector<double> values{};  // of PathSpec::keyed, in Scene's units
    friend bool operator==(const PathKey&, const PathKey&) = default;
};
struct PathSpec {
    PathKind kind = PathKind::kFall;
    PathOrientation orientation = PathOrientation::kGyroscope;
    int frames = 240;
    double rate = 24.0;                     // frames per second
    PathEasing easing = PathEasing::kNone;  // kKeys; kSmooth: from rest to rest (observer/path.h)
    PathTurn turn = PathTurn::kAngles;  // kKeys: of yaw, pitch, roll, or about one axis in world axes; not in a zoom
    double duration = 0.0;      // kFall: proper time from the first frame to the last, r_s/c; 0: to the worldline's end
    std::vector<PathKey> keys;  // kKeys: two or more, by ascending frame
    std::vector<std::string> keyed;  // numbers of the scene that its keys set: "spacetime.spin", "ball[2].radius"
    bool closed = false;             // kKeys: frame `frames` is the first again
    friend bool operator==(const PathSpec&, const PathSpec&) = default;
};

// The object in the sky that the scene stands for: one that is known by its name, whose numbers these replace, or another.
struct ObjectSpec {
    std::optional<double> mass_suns, distance_pc;
    ObjectName name = ObjectName::kOther;
    std::optional<double> mass() const {  // suns
        const KnownObject* known = known_object(name);
        return mass_suns || known == nullptr ? mass_suns : known->mass_suns;
    }
    std::optional<double> distance() const {  // pc
        const KnownObject* known = known_object(name);
        return distance_pc || known == nullptr ? distance_pc : known->distance_pc;
    }
    friend bool operator==(const ObjectSpec&, const ObjectSpec&) = default;
};

// What is written over the halves of a split screen; empty: what differs between them.
struct SplitLabels {
    bool shown = true;
    std::string left{}, right{};
};

struct Scene {
    std::string name, description;
    SpacetimeSpec spacetime;
    std::optional<SpacetimeSpec> split;  // split screen (scene/split.h): spacetime of the right half
    bool split_delay = true;             // light-travel time there
    SplitLabels split_labels;
    ObjectSpec object;
    CameraSpec camera;
    SkySpec sky;
    SkySpec far_sky = default_far_sky();  // of wormholes: at l = -infinity
    std::optional<DiscSpec> disc;
    std::vector<SpotSpec> spots;  // in the disc
    std::optional<MediumSpec> medium;
    std::vector<Body> bodies;
    std::vector<CapSpec> caps;  // on the sphere that is seen (scene/bodies.h)
    LightSpec light;
    PictureSpec picture;
    std::optional<PathSpec> path;
    // Coordinate time of the camera, r_s/c; of a falling camera v - r with v = t + r_*, which is regular on the horizon.
    double time = 0.0;
};

// Whether some of its light is polarised: a thermal disc's, or that of matter along rays.
inline bool has_polarised_disc(const Scene& scene) {
    return scene.disc && scene.disc->emission == DiscEmission::kThermal &&
           scene.disc->polarisation.by != Polarisation::kOff;
}
inline bool has_polarised_medium(const Scene& scene) { return scene.medium && is_polarised(*scene.medium); }
inline bool is_polarised(const Scene& scene) { return has_polarised_disc(scene) || has_polarised_medium(scene); }

}  // namespace nullscope
