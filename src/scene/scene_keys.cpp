#include "scene/scene_keys.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/text.h"
#include "scene/body_keys.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr KeyRange kAnyAngle{-3600.0, 3600.0, false, false};  // ten turns: digits are left after reduction
constexpr KeyRange kLength{0.0, 1e6, true, false};
constexpr KeyRange kPlane{1e-6, 1e6, false, false};  // so that no ratio of two overflows
constexpr KeyRange kBrightness{0.0, 1e6, false, false};
constexpr KeyRange kRadius{-1e9, 1e9, false, false};
constexpr KeyRange kPolarAngle{0.0, 180.0, false, false};
constexpr KeyRange kFov{0.0, 180.0, true, true};
constexpr KeyRange kPixels{1.0, 16384.0, false, false};
constexpr KeyRange kExposure{-30.0, 30.0, false, false};
constexpr KeyRange kLatitude{0.0, 90.0, true, true};
constexpr KeyRange kOpacity{0.0, 1.0, false, false};
constexpr KeyRange kEdge{0.0, 0.5, false, false};
constexpr KeyRange kTemperature{1e3, 1e9, false, false};
constexpr KeyRange kMass{1e-6, 1e12, false, false};
constexpr KeyRange kRate{1e-9, 1e6, false, false};
constexpr KeyRange kTime{-1e9, 1e9, false, false};
constexpr KeyRange kMagnitude{-5.0, 30.0, false, false};
constexpr KeyRange kStarCount{0.0, 4000000.0, false, false};
constexpr KeyRange kBloom{0.0, 1.0, false, true};
constexpr KeyRange kEnergy{0.0, 1e6, true, false};
constexpr KeyRange kFrames{2.0, 1000000.0, false, false};
constexpr KeyRange kFilmRate{0.1, 1000.0, false, false};
constexpr KeyRange kDuration{0.0, 1e7, false, false};
constexpr KeyRange kLife{0.0, 1e6, true, false};
constexpr KeyRange kSpots{1.0, 64.0, false, false};
constexpr KeyRange kNone{};

AccretionSpec& accretion_of(Scene& scene) {
    if (!scene.disc->accretion) scene.disc->accretion.emplace();
    return *scene.disc->accretion;
}

constexpr SceneKey kKeys[] = {
    {"", "name", KeyType::kText, "", "", kNone, "", "Title; the file's stem where it is missing.",
     [](Scene& s, const KeyValue& v) { s.name = v.text; }},
    {"", "description", KeyType::kText, "", "", kNone, "", "One sentence that says what is to be seen.",
     [](Scene& s, const KeyValue& v) { s.description = v.text; }},

    {"", "time", KeyType::kNumber, "r_s/c", "0", kTime, "", "Time of the picture, at the camera, for what moves.",
     [](Scene& s, const KeyValue& v) { s.time = v.number; }},

    {"spacetime", "metric", KeyType::kMetric, "", "schwarzschild", kNone, "", "The spacetime.",
     [](Scene& s, const KeyValue& v) { s.spacetime.metric = v.text; }},

    {"beside", "metric", KeyType::kMetric, "", "schwarzschild", kNone, "", "The spacetime of the picture's right half.",
     [](Scene& s, const KeyValue& v) { s.beside->metric = v.text; }},
    {"beside", "delay", KeyType::kChoice, "", "on", kNone, "on off", "Whether light takes time in that half too.",
     [](Scene& s, const KeyValue& v) { s.beside_delay = v.choice == 0; }},

    {"camera", "r", KeyType::kNumber, "r_s", "15", kRadius, "",
     "Radial coordinate; outside the horizon where the observer rests or orbits. Of wormholes: l.",
     [](Scene& s, const KeyValue& v) { s.camera.r = v.number; }},
    {"camera", "theta", KeyType::kNumber, "deg", "84.8", kPolarAngle, "",
     "Polar angle: 0 above the north pole, 90 in the disc's plane.",
     [](Scene& s, const KeyValue& v) { s.camera.theta = v.number; }},
    {"camera", "phi", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Azimuth; about a rotating hole, where the observer falls, of the ingoing coordinates.",
     [](Scene& s, const KeyValue& v) { s.camera.phi = v.number; }},
    {"camera", "yaw", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Turn to the right, away from the centre, which the camera looks at.",
     [](Scene& s, const KeyValue& v) { s.camera.yaw = v.number; }},
    {"camera", "pitch", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Turn up, after yaw.",
     [](Scene& s, const KeyValue& v) { s.camera.pitch = v.number; }},
    {"camera", "roll", KeyType::kNumber, "deg", "0", kAnyAngle, "",
     "Turn about the line of sight that takes the camera's top to its right, after pitch.",
     [](Scene& s, const KeyValue& v) { s.camera.roll = v.number; }},
    {"camera", "observer", KeyType::kChoice, "", "static", kNone,
     "static rain fall throw orbit zamo carter counter-orbit",
     "Observer: static; rain (free fall from rest at infinity); fall (from rest at fall_from); throw (geodesic of "
     "given "
     "energy); orbit and counter-orbit (prograde, retrograde circular geodesic); zamo (without angular momentum) and "
     "carter (Carter's frame), about a rotating hole.",
     [](Scene& s, const KeyValue& v) { s.camera.observer = static_cast<ObserverKind>(v.choice); }},
    {"camera", "fall_from", KeyType::kNumber, "r_s", "1e+06", kRadius, "",
     "Radius where the fall began; needs observer = \"fall\".",
     [](Scene& s, const KeyValue& v) { s.camera.fall_from = v.number; }},
    {"camera", "energy", KeyType::kNumber, "", "1", kEnergy, "",
     "Energy per rest mass, 1 for a fall from rest at infinity; needs observer = \"throw\".",
     [](Scene& s, const KeyValue& v) { s.camera.energy = v.number; }},
    {"camera", "velocity", KeyType::kVelocity, "c", "[0, 0, 0]", kNone, "",
     "Velocity in the observer's frame along (e_r, e_theta, e_phi): outward, southward, towards growing phi.",
     [](Scene& s, const KeyValue& v) { s.camera.velocity = v.vector; }},
    {"camera", "fov", KeyType::kNumber, "deg", "60", kFov, "",
     "Horizontal field of view; instead of plane_width and focal_distance.",
     [](Scene& s, const KeyValue& v) {
         s.camera.plane_width = 2.0 * std::tan(0.5 * v.number);
         s.camera.focal_distance = 1.0;
     }},
    {"camera", "plane_width", KeyType::kNumber, "", "1.1547", kPlane, "",
     "Width of the projection plane, in the unit of focal_distance.",
     [](Scene& s, const KeyValue& v) { s.camera.plane_width = v.number; }},
    {"camera", "focal_distance", KeyType::kNumber, "", "1", kPlane, "",
     "Distance of the projection plane from the focal point.",
     [](Scene& s, const KeyValue& v) { s.camera.focal_distance = v.number; }},
    {"camera", "size", KeyType::kSize, "px", "[1280, 720]", kPixels, "",
     "Width and height of the picture; pixels are square.",
     [](Scene& s, const KeyValue& v) { s.camera.width = v.width, s.camera.height = v.height; }},
    {"camera", "exposure", KeyType::kNumber, "EV", "0", kExposure, "",
     "The displayed brightness is multiplied by 2^exposure.",
     [](Scene& s, const KeyValue& v) { s.camera.exposure_ev = v.number; }},

    {"path", "kind", KeyType::kChoice, "", "fall", kNone, "fall keys",
     "How the camera moves from frame to frame: let go at frame 0, a geodesic; or smoothly through [[path.key]].",
     [](Scene& s, const KeyValue& v) { s.path->kind = static_cast<PathKind>(v.choice); }},
    {"path", "look", KeyType::kChoice, "", "gyroscope", kNone, "gyroscope centre",
     "Of kind = \"fall\": the camera's axes are carried along parallel, or it keeps looking as it did against the "
     "centre.",
     [](Scene& s, const KeyValue& v) { s.path->look = static_cast<PathLook>(v.choice); }},
    {"path", "frames", KeyType::kWhole, "", "240", kFrames, "",
     "Number of frames; of kind = \"keys\" by default those up to the last key.",
     [](Scene& s, const KeyValue& v) { s.path->frames = v.width; }},
    {"path", "rate", KeyType::kNumber, "1/s", "24", kFilmRate, "", "Frames per second of a film.",
     [](Scene& s, const KeyValue& v) { s.path->rate = v.number; }},
    {"path", "duration", KeyType::kNumber, "r_s/c", "0", kDuration, "",
     "Of kind = \"fall\": proper time from the first frame to the last; 0: to the worldline's end.",
     [](Scene& s, const KeyValue& v) { s.path->duration = v.number; }},

    {"sky", "kind", KeyType::kChoice, "", "stars", kNone,
     "stars image black points plain checker grid stripes noise formula",
     "The celestial sphere: the stars and Milky Way that ship as a picture, an image, nothing, the stars as points; or "
     "one colour or a pattern of two.",
     [](Scene& s, const KeyValue& v) { s.sky.kind = static_cast<SkyKind>(v.choice); }},
    {"sky", "mapping", KeyType::kChoice, "", "equirectangular", kNone, "equirectangular band-and-caps",
     "How images cover the sphere: one for all of it, or a band about the equator and a cap on each pole.",
     [](Scene& s, const KeyValue& v) { s.sky.mapping = static_cast<SkyMapping>(v.choice); }},
    {"sky", "image", KeyType::kImage, "", "", kNone, "",
     "The equirectangular image, or the band; needs kind = \"image\".",
     [](Scene& s, const KeyValue& v) { s.sky.image = v.path; }},
    {"sky", "north_cap", KeyType::kImage, "", "", kNone, "",
     "Azimuthal equidistant image of the north cap; needs mapping = \"band-and-caps\".",
     [](Scene& s, const KeyValue& v) { s.sky.north_cap = v.path; }},
    {"sky", "south_cap", KeyType::kImage, "", "", kNone, "",
     "Azimuthal equidistant image of the south cap; needs mapping = \"band-and-caps\".",
     [](Scene& s, const KeyValue& v) { s.sky.south_cap = v.path; }},
    {"sky", "band_latitude", KeyType::kNumber, "deg", "45", kLatitude, "",
     "Latitude where the band ends and the caps begin; needs mapping = \"band-and-caps\".",
     [](Scene& s, const KeyValue& v) { s.sky.band_latitude = v.number; }},
    {"sky", "yaw", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Turn of the sky about the polar axis, after tilt.",
     [](Scene& s, const KeyValue& v) { s.sky.yaw = v.number; }},
    {"sky", "tilt", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Turn of the sky about the world's x axis.",
     [](Scene& s, const KeyValue& v) { s.sky.tilt = v.number; }},
    {"sky", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Factor on the sky's light.",
     [](Scene& s, const KeyValue& v) { s.sky.brightness = v.number; }},
    {"sky", "temperature", KeyType::kNumber, "K", "", kTemperature, "",
     "Of the black body for which the light of kind \"stars\", \"image\" and the Milky Way is taken where g changes "
     "it; without it g does not.",
     [](Scene& s, const KeyValue& v) { s.sky.temperature_K = v.number; }},
    {"sky", "faintest", KeyType::kNumber, "mag", "20", kMagnitude, "",
     "Of kind = \"points\": stars fainter than this are left out; of even_stars, the magnitude of each.",
     [](Scene& s, const KeyValue& v) { s.sky.faintest = v.number; }},
    {"sky", "even_stars", KeyType::kWhole, "", "0", kStarCount, "",
     "Of kind = \"points\", above 0: so many equal stars of 5 772 K, evenly spread, and no catalogue.",
     [](Scene& s, const KeyValue& v) { s.sky.even_stars = v.width; }},

    {"far_sky", "kind", KeyType::kChoice, "", "stars", kNone, "stars image black",
     "The sky at the other end of a wormhole, l = -infinity: as sky.kind.",
     [](Scene& s, const KeyValue& v) { s.far_sky.kind = static_cast<SkyKind>(v.choice); }},
    {"far_sky", "image", KeyType::kImage, "", "", kNone, "", "Its equirectangular image; needs kind = \"image\".",
     [](Scene& s, const KeyValue& v) { s.far_sky.image = v.path; }},
    {"far_sky", "yaw", KeyType::kNumber, "deg", "120", kAnyAngle, "", "Turn of it about the polar axis, after tilt.",
     [](Scene& s, const KeyValue& v) { s.far_sky.yaw = v.number; }},
    {"far_sky", "tilt", KeyType::kNumber, "deg", "90", kAnyAngle, "", "Turn of it about the world's x axis.",
     [](Scene& s, const KeyValue& v) { s.far_sky.tilt = v.number; }},
    {"far_sky", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Factor on its light.",
     [](Scene& s, const KeyValue& v) { s.far_sky.brightness = v.number; }},

    {"disc", "inner", KeyType::kNumber, "r_s", "3", kLength, "", "Inner radius; below outer.",
     [](Scene& s, const KeyValue& v) { s.disc->inner = v.number; }},
    {"disc", "outer", KeyType::kNumber, "r_s", "12", kLength, "", "Outer radius.",
     [](Scene& s, const KeyValue& v) { s.disc->outer = v.number; }},
    {"disc", "image", KeyType::kImage, "", "", kNone, "",
     "Image whose square covers the disc's square; the disc image that ships where it is missing. Needs texture = "
     "\"image\".",
     [](Scene& s, const KeyValue& v) { s.disc->image = v.path; }},
    {"disc", "emission", KeyType::kChoice, "", "image", kNone, "image thermal",
     "Where its light comes from: image or texture, as they are, or the heat that matter gains on its way in (these "
     "then give emissivities).",
     [](Scene& s, const KeyValue& v) { s.disc->emission = static_cast<DiscEmission>(v.choice); }},
    {"disc", "temperature", KeyType::kNumber, "K", "8000", kTemperature, "",
     "Of the hottest ring of a thermal disc, in its own frame; brightness 1 is that ring's.",
     [](Scene& s, const KeyValue& v) { s.disc->temperature_K = v.number; }},
    {"disc", "mass", KeyType::kNumber, "M_sun", "", kMass, "",
     "Mass of the hole. With accretion_rate it gives the temperature of a thermal disc, by Stefan and Boltzmann's law.",
     [](Scene& s, const KeyValue& v) { accretion_of(s).mass_suns = v.number; }},
    {"disc", "accretion_rate", KeyType::kNumber, "L_Edd/0.1 c^2", "", kRate, "",
     "What falls in, over the rate that shines with Eddington's luminosity at an efficiency of 0.1 (2.2e-8 M_sun a "
     "year for each M_sun); needs mass.",
     [](Scene& s, const KeyValue& v) { accretion_of(s).rate_eddington = v.number; }},
    {"disc", "opacity", KeyType::kNumber, "", "1", kOpacity, "", "Below 1, what lies behind the disc shines through.",
     [](Scene& s, const KeyValue& v) { s.disc->opacity = v.number; }},
    {"disc", "edge", KeyType::kNumber, "", "0", kEdge, "",
     "Width of the fade at both rims, as a fraction of outer - inner.",
     [](Scene& s, const KeyValue& v) { s.disc->edge = v.number; }},
    {"disc", "rotation", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Turn of image or texture about the polar axis.",
     [](Scene& s, const KeyValue& v) { s.disc->rotation = v.number; }},
    {"disc", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Factor on the disc's light.",
     [](Scene& s, const KeyValue& v) { s.disc->brightness = v.number; }},

    {"disc", "flow", KeyType::kChoice, "", "still", kNone, "still kepler",
     "How image or texture moves: not at all, or every ring with the matter's own speed.",
     [](Scene& s, const KeyValue& v) { s.disc->flow = static_cast<DiscFlowKind>(v.choice); }},
    {"disc", "flow_life", KeyType::kNumber, "r_s/c", "40", kLife, "",
     "How long a copy of the pattern is wound up before it has faded into the next; needs flow = \"kepler\".",
     [](Scene& s, const KeyValue& v) { s.disc->flow_life = v.number; }},

    {"spot", "r", KeyType::kNumber, "r_s", "3.5", kLength, "",
     "Radius of the orbit; outside the photon sphere and within the disc.",
     [](Scene& s, const KeyValue& v) { s.spot->r = v.number; }},
    {"spot", "phase", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Azimuth at time 0.",
     [](Scene& s, const KeyValue& v) { s.spot->phase = v.number; }},
    {"spot", "size", KeyType::kNumber, "r_s", "0.35", kLength, "",
     "Standard deviation of its light, a Gaussian of the distance in the disc.",
     [](Scene& s, const KeyValue& v) { s.spot->size = v.number; }},
    {"spot", "brightness", KeyType::kNumber, "", "1", kBrightness, "",
     "Factor on its light: 1 is a black body's in its middle.",
     [](Scene& s, const KeyValue& v) { s.spot->brightness = v.number; }},
    {"spot", "temperature", KeyType::kNumber, "K", "8000", kTemperature, "", "Of the black body whose colour it has.",
     [](Scene& s, const KeyValue& v) { s.spot->temperature_K = v.number; }},
    {"spot", "count", KeyType::kWhole, "", "1", kSpots, "", "Number of spots, evenly spaced along the orbit.",
     [](Scene& s, const KeyValue& v) { s.spot->count = v.width; }},

    {"light", "shift", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether motion and gravity change the colour of what shines by its heat.",
     [](Scene& s, const KeyValue& v) { s.light.shift = v.choice == 0; }},
    {"light", "beaming", KeyType::kChoice, "", "on", kNone, "on off", "Whether they change its brightness.",
     [](Scene& s, const KeyValue& v) { s.light.beaming = v.choice == 0; }},
    {"light", "doppler", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether motion of matter and camera changes frequencies: that part of g.",
     [](Scene& s, const KeyValue& v) { s.light.doppler = v.choice == 0; }},
    {"light", "gravity", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether the way out of gravity changes them: the other part of g.",
     [](Scene& s, const KeyValue& v) { s.light.gravity = v.choice == 0; }},
    {"light", "aberration", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether a moving camera sees directions other than one at rest in its place.",
     [](Scene& s, const KeyValue& v) { s.light.aberration = v.choice == 0; }},
    {"light", "delay", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether light takes time: what moves is seen where it was when its light left; else where it is.",
     [](Scene& s, const KeyValue& v) { s.light.delay = v.choice == 0; }},
    {"light", "lensing", KeyType::kChoice, "", "on", kNone, "on off",
     "Whether light follows the geodesics of the metric; else straight lines, and all else is as it is.",
     [](Scene& s, const KeyValue& v) { s.light.lensing = v.choice == 0; }},
    {"light", "band", KeyType::kChoice, "", "visual", kNone, "visual bolometric",
     "What counts as brightness of what shines by its heat: what the eye sees, or power at all wavelengths.",
     [](Scene& s, const KeyValue& v) { s.light.bolometric = v.choice == 1; }},

    {"picture", "tone", KeyType::kChoice, "", "shoulder", kNone, "shoulder film neutral",
     "How bright light is compressed: 1 - exp(-x), a fit of the film curve of ACES, or Khronos' neutral curve.",
     [](Scene& s, const KeyValue& v) { s.picture.tone = static_cast<ToneCurve>(v.choice); }},
    {"picture", "bloom", KeyType::kNumber, "", "0", kBloom, "",
     "Share of the light that lens and eye scatter about its place.",
     [](Scene& s, const KeyValue& v) { s.picture.bloom = v.number; }},
    {"picture", "auto_exposure", KeyType::kChoice, "", "off", kNone, "off on",
     "Whether exposure follows the picture's mean luminance; camera.exposure then adds to it.",
     [](Scene& s, const KeyValue& v) { s.picture.auto_exposure = v.choice == 1; }},
    {"picture", "dither", KeyType::kChoice, "", "off", kNone, "off on",
     "Noise of half a step of 8 bits, so that dark gradients show no bands.",
     [](Scene& s, const KeyValue& v) { s.picture.dither = v.choice == 1; }},
};

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    return list;
}

}  // namespace

std::span<const SceneKey> scene_keys() {
    static const std::vector<SceneKey> keys = [] {
        std::vector<SceneKey> all(std::begin(kKeys), std::end(kKeys));
        append_body_keys(all);
        return all;
    }();
    return keys;
}

std::string full_name(const SceneKey& key) {
    return key.section.empty() ? std::string(key.key) : fmt::format("{}.{}", key.section, key.key);
}

KeyRange key_range(std::string_view name) {
    for (const SceneKey& key : scene_keys())
        if (full_name(key) == name) return key.range;
    std::abort();
}

std::string allowed_text(const SceneKey& key) {
    const KeyRange& range = key.range;
    switch (key.type) {
        case KeyType::kNumber:
            return fmt::format("{}{}, {}{}", range.open_low ? '(' : '[', range.low, range.high,
                               range.open_high ? ')' : ']');
        case KeyType::kVelocity: return "three numbers, speed below 1";
        case KeyType::kPoint:
        case KeyType::kColour: return fmt::format("three numbers from {} to {}", range.low, range.high);
        case KeyType::kWhole: return fmt::format("an integer from {} to {}", range.low, range.high);
        case KeyType::kFormula: return fmt::format("a formula of {}", list_of(split(key.choices, ' ')));
        case KeyType::kSize: return fmt::format("two integers from {} to {}", range.low, range.high);
        case KeyType::kChoice: return list_of(split(key.choices, ' '));
        case KeyType::kText: return fmt::format("one line of at most {} bytes", kLongestText);
        case KeyType::kImage: return "an image file, relative to the scene file";
        case KeyType::kMetric: break;
    }
    std::vector<std::string> metrics;
    for (const MetricEntry& entry : metric_registry()) metrics.emplace_back(entry.key);
    return list_of(metrics);
}

}  // namespace nullscope
