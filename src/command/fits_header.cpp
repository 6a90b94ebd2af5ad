#include "command/fits_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <optional>

#include "annotate/annotations.h"
#include "observer/picture_scale.h"
#include "observer/pose.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

constexpr double kDegree = 180.0 / M_PI;
constexpr double kMicroarcsecond_deg = 1e-6 / 3600.0;

// A plane that touches the sphere in `at`, px from the upper left corner.
struct SkyPlane {
    std::array<std::string, 2> types;
    std::string is;
    std::array<double, 2> at, value_deg, step_deg;
};

void add_plane(const SkyPlane& plane, int height, FitsHeader& header) {
    // Pixels are counted from 1, from the lower left one's middle.
    const std::array<double, 2> pixel = {plane.at[0] + 0.5, height - plane.at[1] + 0.5};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::string number = axis == 0 ? "1" : "2";
        header.cards.push_back({"CTYPE" + number, plane.types[axis], plane.is});
        header.cards.push_back({"CUNIT" + number, "deg", ""});
        header.cards.push_back({"CRPIX" + number, pixel[axis], ""});
        header.cards.push_back({"CRVAL" + number, plane.value_deg[axis], ""});
        header.cards.push_back({"CDELT" + number, plane.step_deg[axis], "what a pixel spans there"});
    }
}

// Where the axis theta = 0, along which the hole spins, points to in the picture about the hole, from its top towards its left. Nothing of a camera
// on the axis, or one that looks away.
void add_axis(const CameraSpec& camera, const char* from_to, FitsHeader& header) {
    constexpr double kOnAxis = 1e-9;
    const Mat3 axes = static_from_camera(camera);
    const Vec3 hole{-1.0, 0.0, 0.0}, axis{0.0, -1.0, 0.0};  // to the hole, and across that line towards theta = 0
    if (std::sin(camera.theta) < kOnAxis) return;
    const auto seen = pixel_of(camera, transposed(axes) * hole);
    if (!seen) return;
    std::array<double, 2> step{};  // of the hole's image along that axis, px right and down
    if (projection_of(camera).flat) {
        const Vec3 ahead = -axes.c;
        const auto shift = [&](Vec3 side) {
            return dot(axis, side) * dot(hole, ahead) - dot(hole, side) * dot(axis, ahead);
        };
        step = {shift(axes.a), -shift(axes.b)};
    } else {
        constexpr double kStep = 1e-6;  // rad
        const auto on = pixel_of(camera, transposed(axes) * (hole + kStep * axis)),
                   back = pixel_of(camera, transposed(axes) * (hole - kStep * axis));
        if (!on || !back) return;
        step = {((*on)[0] - (*back)[0]) * camera.pixel_aspect, (*on)[1] - (*back)[1]};
    }
    const double angle = std::fmod(std::atan2(-step[0], -step[1]) * kDegree + 360.0, 360.0);
    header.cards.push_back({"SPIN_PA", angle, std::string("[deg] axis theta = 0 (spin), ") + from_to});
}

// False: the picture shows no object at a known distance by one scale.
bool add_sky(const Scene& scene, FitsHeader& header) {
    const auto microarcsecond = length_of_microarcsecond(scene.object);
    const auto made = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!microarcsecond || !made) return false;
    const auto scale = picture_scale(**made, scene.camera);
    const auto centre = centre_px(**made, scene.camera);
    if (!scale || !centre) return false;
    const KnownObject* known = known_object(scene.object.name);
    const SkyPlace place = known != nullptr && known->place ? *known->place : SkyPlace{0.0, 0.0};
    const double step = scale->length_per_px() / *microarcsecond;
    const ProjectionRow& row = projection_of(scene.camera);
    add_plane({{fmt::format("RA---{}", row.fits), fmt::format("DEC--{}", row.fits)},
               std::string(row.fits_is),
               *centre,
               {place.right_ascension_deg, place.declination_deg},
               {-step * kMicroarcsecond_deg, step * kMicroarcsecond_deg}},
              scene.camera.height, header);
    header.cards.push_back({"RADESYS", "ICRS", ""});
    add_axis(scene.camera, "north to east", header);
    header.cards.push_back({"PIXELUAS", step, "[uas] what a pixel spans"});
    header.comments.emplace_back("Angles are impact parameters over DISTANCE, as from Earth.");
    header.comments.emplace_back("The picture's top is taken as north, its left as east.");
    if (known == nullptr || !known->place)
        header.comments.emplace_back("The object's place in the sky is not known: 0, 0 stands for it.");
    return true;
}

void add_camera_plane(const CameraSpec& camera, FitsHeader& header) {
    const double step = camera.pixel() * kDegree;
    const ProjectionRow& row = projection_of(camera);
    add_plane({{fmt::format("CALN-{}", row.fits), fmt::format("CALT-{}", row.fits)},
               std::string(row.fits_is),
               line_of_sight(camera),
               {0.0, 0.0},
               {step * camera.pixel_aspect, step}},
              camera.height, header);
    add_axis(camera, "up to left", header);
    header.comments.emplace_back("Angles are the camera's own, about its line of sight:");
    header.comments.emplace_back("longitude to the right, latitude upward.");
}

void add_metric(const SpacetimeSpec& spec, FitsHeader& header) {
    header.cards.push_back({"METRIC", spec.metric, ""});
    const MetricEntry* entry = find_metric(spec.metric);
    bool spins = false;
    for (const MetricParameter& parameter : entry->parameters) {
        constexpr std::size_t kLongestKeyword = 8;
        const std::string name(parameter.name);
        std::string keyword = name.substr(0, kLongestKeyword);
        std::ranges::transform(keyword, keyword.begin(), [](unsigned char c) { return std::toupper(c); });
        spins = spins || name == "spin";
        const auto given = spec.parameters.find(name);
        header.cards.push_back({keyword, given != spec.parameters.end() ? given->second : parameter.fallback,
                                "parameter " + name + " of METRIC"});
    }
    for (const auto& [name, text] : spec.parameters.formulas) header.cards.push_back({name, text, "formula of METRIC"});
    if (!spins) header.cards.push_back({"SPIN", 0.0, "METRIC does not rotate"});
}

}  // namespace

void add_coordinates(const Scene& scene, bool several, FitsHeader& header) {
    const CameraSpec& camera = scene.camera;
    if (several || projection_of(camera).fits.empty() || !camera.warp.empty()) {
        header.comments.emplace_back("No coordinates: two pictures, a mesh, or a projection without a code.");
        return;
    }
    if (!add_sky(scene, header)) add_camera_plane(camera, header);
}

void add_scene(const Scene& scene, FitsHeader& header) {
    const KnownObject* known = known_object(scene.object.name);
    header.cards.push_back({"OBJECT", known != nullptr ? std::string(known->name) : scene.name, ""});
    if (const auto mass = scene.object.mass()) header.cards.push_back({"MASS", *mass, "[Msun]"});
    if (const auto distance = scene.object.distance()) header.cards.push_back({"DISTANCE", *distance, "[pc]"});
    if (const auto microarcsecond = length_of_microarcsecond(scene.object))
        header.cards.push_back({"M_UAS", 0.5 / *microarcsecond, "[uas] GM/(c^2 DISTANCE)"});
    add_metric(scene.spacetime, header);
    header.cards.push_back({"CAMERA_R", scene.camera.r, "radial coordinate of the camera, in 2 GM/c^2"});
    header.cards.push_back(
        {"INCLINAT", scene.camera.theta * kDegree, "[deg] polar angle of the camera, 0: on the axis"});
    header.cards.push_back({"SCENTIME", scene.time, "time at the camera, in 2 GM/c^3"});
}

}  // namespace nullscope::cli
