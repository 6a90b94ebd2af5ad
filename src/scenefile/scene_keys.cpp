#include "scenefile/scene_keys.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "observer/ring_view.h"
#include "plan/feature.h"
#include "scene/projection.h"
#include "scenefile/body_keys.h"
#include "scenefile/projection_words.h"
#include "scenefile/sections.h"

namespace nullscope {
namespace {

constexpr KeyRange kPlane = closed(1e-6, 1e6);  // so that no ratio of two overflows
constexpr KeyRange kFov{0.0, 360.0, true, false};
constexpr KeyRange kShift = closed(-10.0, 10.0);
constexpr KeyRange kRadius = closed(-1e9, 1e9);
constexpr KeyRange kTemperature = closed(1e3, 1e9);

// Keys that are more than one member of the scene.
constexpr KeyMember kFieldOfView = {nullptr,
                                    [](Scene& s, const KeyValue& v) { set_field_of_view(s.camera, v.number); }};
constexpr KeyMember kProjection = {
    [](const Scene& s) { return KeyValue{.choice = static_cast<int>(s.camera.projection)}; },
    [](Scene& s, const KeyValue& v) {
        const auto projection = static_cast<Projection>(v.choice);
        if (projection == s.camera.projection) return;
        s.camera.projection = projection;
        set_field_of_view(s.camera, usual_field_of_view(projection));
    }};
constexpr KeyMember kPictureSize = {
    [](const Scene& s) { return KeyValue{.width = s.camera.width, .height = s.camera.height}; },
    [](Scene& s, const KeyValue& v) { s.camera.width = v.width, s.camera.height = v.height; }};

// Of the file, not of the scene.
constexpr KeyMember kFormat = {nullptr, [](Scene&, const KeyValue&) {}};

// Read by the scene's reader, once it knows [camera]; what is read are keys of the path.
constexpr KeyMember kPathFile = {nullptr, [](Scene&, const KeyValue&) {}};

// Two keys that are there together.
template <double AccretionSpec::*Part>
constexpr KeyMember accretion() {
    return {[](const Scene& s) {
                const auto& all = s.disc->accretion;
                return KeyValue{.number = all ? *all.*Part : 0.0, .there = all.has_value()};
            },
            [](Scene& s, const KeyValue& v) {
                if (!s.disc->accretion) s.disc->accretion.emplace();
                *s.disc->accretion.*Part = v.number;
            }};
}

template <SkyKind kind>
bool sky_is(const Scene& s) {
    return s.sky.kind == kind;
}
bool is_flat(const Scene& s) { return projection_of(s.camera).flat; }
bool has_eyes(const Scene& s) { return s.camera.stereo != Stereo::kOff; }
bool has_fov(const Scene& s) { return !projection_of(s.camera).faces; }
bool far_is_nebula(const Scene& s) { return s.far_sky.kind == SkyKind::kNebula; }
bool far_is_image(const Scene& s) { return s.far_sky.kind == SkyKind::kImage; }
bool has_caps(const Scene& s) { return s.sky.mapping == SkyMapping::kBandAndCaps; }
template <PathKind kind>
bool path_is(const Scene& s) {
    return s.path->kind == kind;
}
bool disc_has_image(const Scene& s) { return s.disc->material.texture == TextureKind::kImage; }
bool disc_is_thermal(const Scene& s) { return s.disc->emission == DiscEmission::kThermal; }

constexpr SceneKey kKeys[] = {
    {"", "format", KeyType::kWhole, "", "1", closed(1, kSceneFormat), "",
     "Version of the scene format that the file is written in; newer ones are refused.", kFormat},
    {"", "name", KeyType::kText, "", "", kNoRange, "", "Title; by default the file's name without extension.",
     [](auto& s) { return &s.name; }},
    {"", "description", KeyType::kText, "", "", kNoRange, "", "One sentence that says what the picture shows.",
     [](auto& s) { return &s.description; }},

    {"", "time", KeyType::kNumber, "r_s/c", "0", closed(-1e9, 1e9), "",
     "Time at the camera, for scenes in which something moves.", [](auto& s) { return &s.time; }},

    {"spacetime", "metric", KeyType::kMetric, "", "schwarzschild", kNoRange, "", "The spacetime.",
     [](auto& s) { return &s.spacetime.metric; }},

    {"split", "metric", KeyType::kMetric, "", "schwarzschild", kNoRange, "",
     "The spacetime of the picture's right half.", [](auto& s) { return &s.split->metric; }},
    {"split", "delay", KeyType::kChoice, "", "on", kNoRange, "off on",
     "Whether the right half includes light-travel time.", [](auto& s) { return &s.split_delay; }},
    on_off_key("split", "labels", "on", "Whether a label on each half of the displayed picture says what differs.",
               [](auto& s) { return &s.split_labels.shown; }),
    {"split", "left_label", KeyType::kText, "", "", kNoRange, "",
     "Label of the left half; by default what differs between the halves.",
     [](auto& s) { return &s.split_labels.left; }},
    {"split", "right_label", KeyType::kText, "", "", kNoRange, "", "Label of the right half; likewise.",
     [](auto& s) { return &s.split_labels.right; }},

    {"object", "name", KeyType::kChoice, "", "other", kNoRange, "other m87 sgr-a cygnus-x-1 gargantua",
     "A known object, which sets mass and distance; other: they are set here.", [](auto& s) { return &s.object.name; }},
    {"object", "mass_suns", KeyType::kNumber, "M_sun", "", closed(1e-6, 1e12), "",
     "Mass of the object, by default that of name; needed by scale_bar = \"uas\".",
     [](auto& s) { return &s.object.mass_suns; }},
    {"object", "distance_pc", KeyType::kNumber, "pc", "", closed(1e-6, 1e11), "", "Its distance from Earth; likewise.",
     [](auto& s) { return &s.object.distance_pc; }},

    {"camera", "r", KeyType::kNumber, "r_s", "15", kRadius, "",
     "Radial coordinate; in wormholes the proper distance l. Outside the horizon for observers at rest or in orbit.",
     [](auto& s) { return &s.camera.r; }},
    {"camera", "theta", KeyType::kNumber, "deg", "84.8", closed(0.0, 180.0), "",
     "Polar angle: 0 above the north pole, 90 in the disc's plane.", [](auto& s) { return &s.camera.theta; }},
    {"camera", "phi", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Azimuth; for falling observers about a rotating hole the ingoing azimuth.",
     [](auto& s) { return &s.camera.phi; }},
    {"camera", "yaw", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Rotation to the right; at 0 the camera looks at the centre.", [](auto& s) { return &s.camera.yaw; }},
    {"camera", "pitch", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Rotation upward, after yaw.",
     [](auto& s) { return &s.camera.pitch; }},
    {"camera", "roll", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Rotation about the line of sight, after pitch; the camera's top tilts to its right.",
     [](auto& s) { return &s.camera.roll; }},
    {"camera", "observer", KeyType::kChoice, "", "static", kNoRange,
     "static rain fall throw orbit zamo carter counter-orbit",
     "Observer: static; rain (free fall from rest at infinity); fall (from rest at fall_from); throw (geodesic of "
     "given "
     "energy); orbit and counter-orbit (prograde, retrograde circular geodesic); zamo (without angular momentum) and "
     "carter (Carter's frame), about a rotating hole.",
     [](auto& s) { return &s.camera.observer; }},
    {"camera", "fall_from", KeyType::kNumber, "r_s", "1e+06", kRadius, "",
     "Radius at which the fall started from rest; needs observer = \"fall\".",
     [](auto& s) { return &s.camera.fall_from; },
     [](const Scene& s) { return s.camera.observer == ObserverKind::kFall; }, "observer = \"fall\""},
    {"camera", "energy", KeyType::kNumber, "", "1", kPositive, "",
     "Energy per rest mass; 1 is a fall from rest at infinity. Needs observer = \"throw\".",
     [](auto& s) { return &s.camera.energy; }, [](const Scene& s) { return s.camera.observer == ObserverKind::kThrow; },
     "observer = \"throw\""},
    {"camera", "velocity", KeyType::kVelocity, "c", "[0, 0, 0]", kNoRange, "",
     "Velocity in the observer's frame along (e_r, e_theta, e_phi): outward, southward, towards growing phi.",
     [](auto& s) { return &s.camera.velocity; }},
    {"camera", "projection", KeyType::kChoice, "", "pinhole", kNoRange, kProjectionChoices.view(),
     kProjectionHelp.view(), kProjection},
    {"camera", "fov", KeyType::kNumber, "deg", "60", kFov, "", kFieldOfViewHelp.view(), kFieldOfView, has_fov,
     "a projection that is no cube"},
    {"camera", "plane_width", KeyType::kNumber, "", "1.1547", kPlane, "",
     "Width of a pinhole's projection plane, in the unit of focal_distance; instead of fov.",
     [](auto& s) { return &s.camera.plane_width; }, is_flat, "projection = \"pinhole\""},
    {"camera", "focal_distance", KeyType::kNumber, "", "1", kPlane, "", "Distance of that plane from the focal point.",
     [](auto& s) { return &s.camera.focal_distance; }, is_flat, "projection = \"pinhole\""},
    {"camera", "shift_x", KeyType::kNumber, "", "0", kShift, "",
     "How far the picture's middle lies to the right of the line of sight, in widths of the picture: an off-axis "
     "camera.",
     [](auto& s) { return &s.camera.shift_x; }},
    {"camera", "shift_y", KeyType::kNumber, "", "0", kShift, "", "Likewise upward, in heights of the picture.",
     [](auto& s) { return &s.camera.shift_y; }},
    {"camera", "size", KeyType::kSize, "px", "[1280, 720]", closed(1.0, 65536.0), "",
     "Width and height of the picture. The default of a cube is [1536, 1024].", kPictureSize},
    {"camera", "pixel_aspect", KeyType::kNumber, "", "1", closed(0.1, 10.0), "", "Width of a pixel over its height.",
     [](auto& s) { return &s.camera.pixel_aspect; }},
    {"camera", "exposure", KeyType::kNumber, "EV", "0", closed(-30.0, 30.0), "",
     "The displayed brightness is multiplied by 2^exposure.", [](auto& s) { return &s.camera.exposure_ev; }},

    {"camera", "stereo", KeyType::kChoice, "", "off", kNoRange, "off pair all-round",
     "Pictures for two parallel eyes: pair (side by side, left eye first, twice as wide as size); "
     "all-round "
     "(omnidirectional stereo of an equirectangular picture, the left eye's above the right one's, twice as high).",
     [](auto& s) { return &s.camera.stereo; }},
    {"camera", "eye_distance", KeyType::kNumber, "r_s", "0.1", kPositive, "",
     "Proper distance of the eyes; at most a half of the areal radius.", [](auto& s) { return &s.camera.eye_distance; },
     has_eyes, "stereo = \"pair\" or \"all-round\""},

    {"zoom", "depth", KeyType::kNumber, "", "0", closed(0.0, kDeepestZoom), "",
     "Natural logarithm of the magnification: the picture spans camera.fov times exp(-depth) about a point of the "
     "critical curve. camera.yaw and camera.pitch follow from it.",
     [](auto& s) { return &s.camera.zoom->depth; }},
    {"zoom", "angle", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Which point of the critical curve: 0 at the left of the shadow, 90 at its top.",
     [](auto& s) { return &s.camera.zoom->angle; }},

    {"path", "kind", KeyType::kChoice, "", "fall", kNoRange, "fall keys",
     "How the camera moves: in free fall from frame 0 on, or smoothly through the places given by [[path.key]].",
     [](auto& s) { return &s.path->kind; }},
    {"path", "orientation", KeyType::kChoice, "", "gyroscope", kNoRange, "gyroscope centre",
     "For kind = \"fall\": the camera's axes are parallel-transported, or keep their angle to the centre.",
     [](auto& s) { return &s.path->orientation; }, path_is<PathKind::kFall>, "kind = \"fall\""},
    {"path", "frames", KeyType::kWhole, "", "240", closed(2.0, 1000000.0), "",
     "Number of frames; for kind = \"keys\" by default up to the last key.", [](auto& s) { return &s.path->frames; }},
    {"path", "rate", KeyType::kNumber, "1/s", "24", closed(0.1, 1000.0), "", "Frames per second of a film.",
     [](auto& s) { return &s.path->rate; }},
    {"path", "duration", KeyType::kNumber, "r_s/c", "0", closed(0.0, 1e7), "",
     "For kind = \"fall\": proper time from the first frame to the last; 0: to the worldline's end.",
     [](auto& s) { return &s.path->duration; }, path_is<PathKind::kFall>, "kind = \"fall\""},
    {"path", "file", KeyType::kFile, "", "", kNoRange, "CSV",
     "For kind = \"keys\": a table of the keys, instead of [[path.key]].", kPathFile, path_is<PathKind::kKeys>,
     "kind = \"keys\""},
    {"path", "easing", KeyType::kChoice, "", "none", kNoRange, "none smooth",
     "For kind = \"keys\": frames pass at an even rate, or slowly at both ends: the camera begins and ends at rest.",
     [](auto& s) { return &s.path->easing; }, path_is<PathKind::kKeys>, "kind = \"keys\""},
    {"path", "turn", KeyType::kChoice, "", "angles", kNoRange, "angles shortest",
     "For kind = \"keys\": yaw, pitch and roll are interpolated, or the camera turns the shortest way (slerp).",
     [](auto& s) { return &s.path->turn; }, path_is<PathKind::kKeys>, "kind = \"keys\""},

    {"sky", "kind", KeyType::kChoice, "", "stars", kNoRange,
     "stars image black nebula points plain checker grid stripes noise formula",
     "What is on the celestial sphere: the built-in stars and Milky Way as a picture, an image, nothing, the stars as "
     "points, a procedural emission nebula with stars of its own, one colour, or a pattern of two.",
     [](auto& s) { return &s.sky.kind; }},
    {"sky", "mapping", KeyType::kChoice, "", "equirectangular", kNoRange, "equirectangular band-and-caps",
     "How images cover the sphere: one image for all of it, or a band about the equator and a cap on each pole.",
     [](auto& s) { return &s.sky.mapping; }, sky_is<SkyKind::kImage>, "kind = \"image\""},
    {"sky", "image", KeyType::kFile, "", "", kNoRange, "",
     "The equirectangular image, or the band; needs kind = \"image\".", [](auto& s) { return &s.sky.image; },
     sky_is<SkyKind::kImage>, "kind = \"image\"", true},
    {"sky", "image_layer", KeyType::kText, "", "", kNoRange, "",
     "Which picture of an EXR with several, also of the caps: its layer or part.",
     [](auto& s) { return &s.sky.image_layer; }, sky_is<SkyKind::kImage>, "kind = \"image\""},
    {"sky", "north_cap", KeyType::kFile, "", "", kNoRange, "",
     "Azimuthal equidistant image of the north cap; needs mapping = \"band-and-caps\".",
     [](auto& s) { return &s.sky.north_cap; }, has_caps, "mapping = \"band-and-caps\"", true},
    {"sky", "south_cap", KeyType::kFile, "", "", kNoRange, "",
     "Azimuthal equidistant image of the south cap; needs mapping = \"band-and-caps\".",
     [](auto& s) { return &s.sky.south_cap; }, has_caps, "mapping = \"band-and-caps\"", true},
    {"sky", "band_latitude", KeyType::kNumber, "deg", "45", open(0.0, 90.0), "",
     "Latitude where the band ends and the caps begin; needs mapping = \"band-and-caps\".",
     [](auto& s) { return &s.sky.band_latitude; }, has_caps, "mapping = \"band-and-caps\""},
    {"sky", "yaw", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Rotation of the sky about the polar axis, after tilt.",
     [](auto& s) { return &s.sky.yaw; }},
    {"sky", "tilt", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Rotation of the sky about the world's x axis.",
     [](auto& s) { return &s.sky.tilt; }},
    {"sky", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies the sky's light.",
     [](auto& s) { return &s.sky.brightness; }},
    {"sky", "temperature", KeyType::kNumber, "K", "", kTemperature, "",
     "If set, the redshift factor g acts on the light of kind \"stars\", \"image\", \"nebula\" and the Milky Way as on "
     "a black "
     "body of this temperature; otherwise not at all.",
     [](auto& s) { return &s.sky.temperature_K; },
     [](const Scene& s) { return !is_procedural(s.sky.kind) && s.sky.kind != SkyKind::kBlack; },
     "kind = \"stars\", \"image\", \"points\" or \"nebula\""},
    {"sky", "catalogue", KeyType::kChoice, "", "hipparcos", kNoRange, "hipparcos tycho-2",
     "Stars of the sky: 118 000 of Hipparcos, or with Tycho-2 600 000, to V = 10.5; those have to be fetched once, by "
     "scripts/fetch_stars.py.",
     [](auto& s) { return &s.sky.catalogue; },
     [](const Scene& s) { return s.sky.kind == SkyKind::kStars || s.sky.kind == SkyKind::kPoints; },
     "kind = \"stars\" or \"points\""},
    {"sky", "magnitude_limit", KeyType::kNumber, "mag", "20", closed(-5.0, 30.0), "",
     "Magnitude limit for kind = \"points\": fainter stars are left out. With uniform_stars: the magnitude of each "
     "star.",
     [](auto& s) { return &s.sky.magnitude_limit; }, sky_is<SkyKind::kPoints>, "kind = \"points\""},
    {"sky", "uniform_stars", KeyType::kWhole, "", "0", closed(0.0, 4000000.0), "",
     "For kind = \"points\": if above 0, this many identical stars of 5 772 K, uniformly distributed, replace the "
     "catalogue.",
     [](auto& s) { return &s.sky.uniform_stars; }, sky_is<SkyKind::kPoints>, "kind = \"points\""},
    {"sky", "seed", KeyType::kWhole, "", "1", closed(0.0, 1000000.0), "", "For kind = \"nebula\": seed of its noise.",
     [](auto& s) { return &s.sky.nebula.seed; }, sky_is<SkyKind::kNebula>, "kind = \"nebula\""},
    {"sky", "hydrogen", KeyType::kColour, "", "[1, 0.16, 0.2]", closed(0.0, 1000.0), "",
     "For kind = \"nebula\": colour of its hydrogen, linear red, green and blue.",
     [](auto& s) { return &s.sky.nebula.hydrogen; }, sky_is<SkyKind::kNebula>, "kind = \"nebula\""},
    {"sky", "oxygen", KeyType::kColour, "", "[0.1, 0.62, 0.66]", closed(0.0, 1000.0), "",
     "For kind = \"nebula\": colour of its oxygen, near its hot stars.", [](auto& s) { return &s.sky.nebula.oxygen; },
     sky_is<SkyKind::kNebula>, "kind = \"nebula\""},

    {"far_sky", "kind", KeyType::kChoice, "", "stars", kNoRange, "stars image black nebula",
     "The sky at the other end of a wormhole, l = -infinity; as sky.kind.", [](auto& s) { return &s.far_sky.kind; }},
    {"far_sky", "image", KeyType::kFile, "", "", kNoRange, "", "Its equirectangular image; needs kind = \"image\".",
     [](auto& s) { return &s.far_sky.image; }, far_is_image, "kind = \"image\"", true},
    {"far_sky", "image_layer", KeyType::kText, "", "", kNoRange, "", "As sky.image_layer.",
     [](auto& s) { return &s.far_sky.image_layer; }, far_is_image, "kind = \"image\""},
    {"far_sky", "seed", KeyType::kWhole, "", "1", closed(0.0, 1000000.0), "", "As sky.seed.",
     [](auto& s) { return &s.far_sky.nebula.seed; }, far_is_nebula, "kind = \"nebula\""},
    {"far_sky", "hydrogen", KeyType::kColour, "", "[1, 0.16, 0.2]", closed(0.0, 1000.0), "", "As sky.hydrogen.",
     [](auto& s) { return &s.far_sky.nebula.hydrogen; }, far_is_nebula, "kind = \"nebula\""},
    {"far_sky", "oxygen", KeyType::kColour, "", "[0.1, 0.62, 0.66]", closed(0.0, 1000.0), "", "As sky.oxygen.",
     [](auto& s) { return &s.far_sky.nebula.oxygen; }, far_is_nebula, "kind = \"nebula\""},
    {"far_sky", "yaw", KeyType::kNumber, "deg", "120", kAnyAngle, "", "Its rotation about the polar axis, after tilt.",
     [](auto& s) { return &s.far_sky.yaw; }},
    {"far_sky", "tilt", KeyType::kNumber, "deg", "90", kAnyAngle, "", "Its rotation about the world's x axis.",
     [](auto& s) { return &s.far_sky.tilt; }},
    {"far_sky", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies its light.",
     [](auto& s) { return &s.far_sky.brightness; }},

    {"disc", "inner", KeyType::kNumber, "r_s", "3", kPositive, "", "Inner radius; below outer.",
     [](auto& s) { return &s.disc->inner; }},
    {"disc", "outer", KeyType::kNumber, "r_s", "12", kPositive, "", "Outer radius.",
     [](auto& s) { return &s.disc->outer; }},
    {"disc", "image", KeyType::kFile, "", "", kNoRange, "",
     "Square image that covers the disc; by default the built-in disc image. Needs texture = \"image\".",
     [](auto& s) { return &s.disc->image; }, disc_has_image, "texture = \"image\""},
    {"disc", "image_layer", KeyType::kText, "", "", kNoRange, "",
     "Which picture of an EXR with several: its layer or part.", [](auto& s) { return &s.disc->image_layer; },
     disc_has_image, "texture = \"image\""},
    {"disc", "texture", KeyType::kChoice, "", "image", kNoRange, "plain checker grid stripes noise formula image gas",
     "Surface texture: an image, one colour, a pattern of two colours in azimuth and radius, or turbulent gas.",
     [](auto& s) { return &s.disc->material.texture; }},
    {"disc", "emission", KeyType::kChoice, "", "image", kNoRange, "image thermal",
     "Where its light comes from: the image or texture itself, or thermal emission, by accretion or another "
     "emissivity, which image or texture multiply.",
     [](auto& s) { return &s.disc->emission; }},
    {"disc", "temperature", KeyType::kNumber, "K", "8000", kTemperature, "",
     "Temperature of the hottest ring of a thermal disc, in its own frame; that ring has brightness 1.",
     [](auto& s) { return &s.disc->temperature_K; }},
    {"disc", "mass", KeyType::kNumber, "M_sun", "", closed(1e-6, 1e12), "",
     "Mass of the hole. Together with accretion_rate it sets the temperature of a thermal disc, by the "
     "Stefan-Boltzmann law.",
     accretion<&AccretionSpec::mass_suns>(), disc_is_thermal, "emission = \"thermal\""},
    {"disc", "accretion_rate", KeyType::kNumber, "L_Edd/0.1 c^2", "", closed(1e-9, 1e6), "",
     "Accretion rate over the Eddington rate at an efficiency of 0.1 (2.2e-8 M_sun a year for each M_sun); needs mass.",
     accretion<&AccretionSpec::rate_eddington>(), disc_is_thermal, "emission = \"thermal\""},
    {"disc", "opacity", KeyType::kNumber, "", "1", closed(0.0, 1.0), "",
     "Below 1, what lies behind the disc shines through.", [](auto& s) { return &s.disc->opacity; }},
    {"disc", "edge", KeyType::kNumber, "", "0", closed(0.0, 0.5), "",
     "Width of the soft edge at both rims, as a fraction of outer - inner.", [](auto& s) { return &s.disc->edge; }},
    {"disc", "rotation", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Rotation of image or texture about the disc's axis.", [](auto& s) { return &s.disc->rotation; }},
    {"disc", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies the disc's light.",
     [](auto& s) { return &s.disc->brightness; }},

    {"disc", "flow", KeyType::kChoice, "", "still", kNoRange, "still kepler",
     "How image or texture moves: not at all, or each ring at the orbital speed of the matter.",
     [](auto& s) { return &s.disc->flow; }},
    {"disc", "sense", KeyType::kChoice, "", "eastward", kNoRange, kOrbitSenses,
     "Which way its matter goes round: towards growing or falling phi, or with or against the hole's rotation (without "
     "rotation as eastward and westward).",
     [](auto& s) { return &s.disc->sense; },
     [](const Scene& s) { return s.disc->emission == DiscEmission::kThermal || s.disc->flow == DiscFlowKind::kKepler; },
     "emission = \"thermal\" or flow = \"kepler\""},
    {"disc", "flow_life", KeyType::kNumber, "r_s/c", "40", kPositive, "",
     "Time for which a copy of the pattern is sheared before it has faded into the next; needs flow = \"kepler\", not "
     "used by gas.",
     [](auto& s) { return &s.disc->flow_life; },
     [](const Scene& s) {
         return s.disc->flow == DiscFlowKind::kKepler && s.disc->material.texture != TextureKind::kGas;
     },
     "flow = \"kepler\" and another texture than \"gas\""},

    {"spot", "r", KeyType::kNumber, "r_s", "3.5", kPositive, "",
     "Radius of the orbit; outside the photon sphere and within the disc.", [](auto& s) { return &s.spots.back().r; }},
    {"spot", "phase", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Azimuth at time 0.",
     [](auto& s) { return &s.spots.back().phase; }},
    {"spot", "size", KeyType::kNumber, "r_s", "0.35", kPositive, "",
     "Standard deviation of its Gaussian brightness profile.", [](auto& s) { return &s.spots.back().size; }},
    {"spot", "brightness", KeyType::kNumber, "", "1", kBrightness, "",
     "Multiplies its light; at 1 its centre shines as a black body.",
     [](auto& s) { return &s.spots.back().brightness; }},
    {"spot", "temperature", KeyType::kNumber, "K", "8000", kTemperature, "",
     "Temperature of the black body that gives its colour.", [](auto& s) { return &s.spots.back().temperature_K; }},
    {"spot", "count", KeyType::kWhole, "", "1", closed(1.0, 64.0), "",
     "Number of spots, evenly spaced along the orbit.", [](auto& s) { return &s.spots.back().count; }},
    {"spot", "sense", KeyType::kChoice, "", "eastward", kNoRange, kOrbitSenses,
     "Which way it goes round, as disc.sense.", [](auto& s) { return &s.spots.back().sense; }},

    on_off_key("light", "shift", "on", "Whether Doppler and gravitational shift change the colour of thermal emission.",
               [](auto& s) { return &s.light.shift; }),
    on_off_key("light", "beaming", "on",
               "Whether Doppler and gravitational shift change the brightness of thermal emission.",
               [](auto& s) { return &s.light.beaming; }),
    on_off_key("light", "doppler", "on",
               "Whether the redshift factor g includes the Doppler shift: the motion of matter and camera.",
               [](auto& s) { return &s.light.doppler; }),
    on_off_key("light", "gravity", "on", "Whether g includes the gravitational shift.",
               [](auto& s) { return &s.light.gravity; }),
    on_off_key("light", "aberration", "on",
               "Whether the camera's motion changes the directions from which light arrives.",
               [](auto& s) { return &s.light.aberration; }),
    on_off_key("light", "delay", "on",
               "Whether light-travel time is included; on: moving objects appear where they were when their light "
               "left; off: where they are now.",
               [](auto& s) { return &s.light.delay; }),
    on_off_key("light", "lensing", "on",
               "Whether light follows the geodesics of the metric; off: straight lines, all else unchanged.",
               [](auto& s) { return &s.light.lensing; }),
    {"light", "band", KeyType::kChoice, "", "visual", kNoRange, "visual bolometric",
     "Brightness of thermal emission: as the eye sees it, or power at all wavelengths.",
     [](auto& s) { return &s.light.bolometric; }},

    {"picture", "tone", KeyType::kChoice, "", "shoulder", kNoRange, "shoulder film neutral",
     "Tone curve: 1 - exp(-x), a fit of the ACES film curve, or Khronos' neutral curve.",
     [](auto& s) { return &s.picture.tone; }},
    {"picture", "shutter", KeyType::kNumber, "", "0", closed(0.0, 1.0), "",
     "Motion blur of films: fraction of the frame interval for which the shutter is open, centred on the frame's time. "
     "0.5 is a film camera's usual 180 degrees.",
     [](auto& s) { return &s.picture.shutter; }},
    {"picture", "sub_frames", KeyType::kWhole, "", "16", closed(1.0, 256.0), "",
     "Number of pictures averaged for each frame with motion blur, if anything moves.",
     [](auto& s) { return &s.picture.sub_frames; }},
    {"picture", "scale_bar", KeyType::kChoice, "", "off", kNoRange, "off M r_s uas",
     "A bar of a round length over the displayed picture: in M = GM/c^2, in r_s, or in microarcseconds at the "
     "distance of [object]. For cameras at rest that look at the centre from at least 20 r_s.",
     [](auto& s) { return &s.picture.scale_bar; }},
};

}  // namespace

std::span<const SceneKey> scene_keys() {
    static const std::vector<SceneKey> keys = [] {
        std::vector<SceneKey> all(std::begin(kKeys), std::end(kKeys));
        append_body_keys(all);
        for (const auto group : feature_groups())
            for (const Feature& feature : group) all.insert(all.end(), feature.keys.begin(), feature.keys.end());
        for (const Section& section : sections()) all.insert(all.end(), section.keys.begin(), section.keys.end());
        return all;
    }();
    return keys;
}

KeyRange key_range(std::string_view name) {
    for (const SceneKey& key : scene_keys())
        if (name.ends_with(key.key) && name.starts_with(key.section) &&
            name.size() == key.section.size() + key.key.size() + (key.section.empty() ? 0 : 1))
            return key.range;
    std::abort();
}

}  // namespace nullscope
