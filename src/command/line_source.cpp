#include "command/line_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "base/text.h"
#include "command/line_emissivity.h"
#include "observer/pose.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "scene/orbit_sense.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"
#include "table/disc_light.h"
#include "table/distant_polarisation.h"

namespace nullscope::cli {
namespace {

constexpr double kOuter = 200.0;         // r_s, without a scene's disc: 400 GM/c^2, Laor's
constexpr double kInclination_deg = 30;  // without a scene
constexpr double kAboveHorizon = 1.001;  // of its radius: innermost rim

// A number in [least, most], or nothing.
std::optional<double> number_in(const std::string& text, double least, double most) {
    const auto value = parse_number(text);
    return value && *value >= least && *value <= most ? value : std::nullopt;
}

std::string name_of(const Scene& scene) {
    std::string name = scene.name.empty() ? "" : without_controls(scene.name) + ": ";
    name += scene.spacetime.metric;
    for (const auto& [key, value] : scene.spacetime.parameters) name += fmt::format(", {} {:g}", key, value);
    for (const auto& [key, text] : scene.spacetime.parameters.formulas)
        name += fmt::format(", {} = {}", key, without_controls(text));
    return name;
}

// The rims, from where light comes to the observer.
Status set_rims(LineSource& source, const LineOptions& options, const std::optional<DiscSpec>& disc) {
    if (options.ring && (!options.inner.empty() || options.outer))
        return bad_input("--ring with --inner or --outer", "a ring or a disc");
    if (options.ring && !source.thermal() && !options.emissivity.empty())
        return bad_input("--emissivity: no effect on a --ring of one radius", "a disc, or thermal");
    source.inner = disc && options.inner.empty() ? disc->inner : source.isco;
    if (!options.inner.empty() && options.inner != "isco") {
        const auto inner = number_in(options.inner, 0.0, kFarthestRim);
        if (!inner)
            return bad_input(fmt::format("--inner {}: not a radius", options.inner),
                             fmt::format("isco, or r_s from 0 to {:g}", kFarthestRim));
        source.inner = *inner;
    }
    source.outer = options.outer.value_or(disc ? disc->outer : kOuter);
    if (options.ring) source.inner = source.outer = *options.ring;
    const double least = kAboveHorizon * *source.spacetime->horizon_radius();
    if (!(source.inner >= least))
        return bad_input(options.ring
                             ? fmt::format("--ring {:g} is not outside of the horizon", *options.ring)
                             : fmt::format("an inner rim of {:g} r_s is not outside of the horizon", source.inner),
                         fmt::format("r_s from {:.6g} on", least));
    if (!options.ring && !(source.outer > source.inner))
        return bad_input(fmt::format("an outer rim of {:g} r_s is not outside of the inner one", source.outer),
                         fmt::format("--outer above {:.10g}", source.inner));
    if (!source.thermal()) return Done{};
    if (!(source.outer > source.isco))
        return bad_input(
            fmt::format("a thermal disc is dark within the innermost stable orbit, {:.10g} r_s", source.isco),
            "radii outside of it, or another --emissivity");
    source.inner = std::max(source.inner, source.isco);
    return Done{};
}

// Of the camera, from the disc's axis, rad.
double from_axis(const Scene& scene) {
    if (!disc_leans(scene)) return scene.camera.theta;
    return angle_between(world_from_static(scene.camera.theta, scene.camera.phi).a, disc_plane_of(scene).normal);
}

}  // namespace

Result<LineSource> line_source(const LineOptions& options) {
    Scene scene;
    if (!options.scene.empty()) {
        if (options.spin) return bad_input("--spin with a scene, which has its own spacetime", "a scene or --spin");
        TRY(loaded, load_scene(options.scene));
        scene = std::move(*loaded);
    } else if (options.spin) {
        scene.spacetime = {"kerr", MetricParameters{{"spin", *options.spin}}};
    }
    return line_source(options, std::move(scene));
}

Result<LineSource> line_source(const LineOptions& options, Scene scene) {
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    if (disc_leans(scene) && (*spacetime)->rotates())
        return bad_input("lines are of discs in the equatorial plane of a rotating hole", "disc.tilt = 0");
    if (disc_warps(scene))
        return bad_input("lines are of flat discs without gaps", "a scene without disc.warp_radii and disc.rings");
    LineSource source{name_of(scene), *spacetime};
    const double theta_deg = options.scene.empty() ? kInclination_deg : from_axis(scene) / kOneDegree,
                 from_axis_deg = options.inclination_deg.value_or(theta_deg);
    source.inclination_deg = from_axis_deg;
    source.inclination = std::min(from_axis_deg, 180.0 - from_axis_deg) * kOneDegree;  // from below it is the same
    TRY(emissivity, line_emissivity(options.emissivity, scene));
    source.emissivity = std::move(*emissivity);
    TRY(light, DistantLight::make(*spacetime, source.inclination));  // which has an innermost stable orbit then
    if (scene.disc) source.sense = sense_about(**spacetime, scene.disc->sense);
    source.isco = *innermost_stable_orbit(**spacetime, source.sense);
    TRY(rims, set_rims(source, options, scene.disc));
    TRY(shines, lit_part(source.emissivity, **spacetime, source.inner, source.outer));
    source.scene = std::move(scene);
    return source;
}

DiscLine disc_line(const LineSource& source, const LineOptions& options) {
    DiscLine line{source.inner, source.outer, {}};
    line.sense = source.sense;
    line.limb = options.limb == "laor" ? Limb::kLaor : options.limb == "haardt" ? Limb::kHaardt : Limb::kIsotropic;
    line.emissivity = [&source](const std::vector<double>& radii) {
        return source.thermal() ? disc_flux(*source.spacetime, radii, source.sense)
                                : disc_emissivity(*source.spacetime, radii, source.emissivity, source.sense);
    };
    if (source.emissivity.by == Emissivity::kPowerLaw) line.kinks = source.emissivity.breaks;
    if (!is_polarised(source.scene)) return line;
    const PolarisationSpec& spec = source.scene.disc->polarisation;
    Vec3 field = field_of(spec);
    if (source.from_below())
        field.z = -field.z;  // in the mirror of the disc's plane, whose vectors of fields are turned
    const auto seen = std::make_shared<const DistantPolarisation>(source.spacetime, source.inclination, field,
                                                                  polarised_fraction(spec), source.sense);
    line.polarisation = [seen, up = source.from_below() ? -1.0 : 1.0](double r) -> LinePolarisation {
        return [of_ring = seen->ring(r), up](const LinePhoton& p) {
            const std::complex<double> linear = of_ring({p.alpha, p.beta, p.lambda, p.eta, p.slope});
            return std::complex(linear.real(), up * linear.imag());
        };
    };
    return line;
}

}  // namespace nullscope::cli
