#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>

#include "module/arrays.h"
#include "module/call.h"
#include "module/module.h"
#include "observer/landmarks.h"
#include "reference/reference.h"
#include "scenefile/scene_writer.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/photon_shell.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::python {

Space space_of(const SpacetimeSpec& spec) { return {spec, value_of(make_spacetime(spec.metric, spec.parameters))}; }

namespace {

Space make_space(const nb::object& metric, const nb::kwargs& parameters) {
    SpacetimeSpec spec{text_of("metric", metric), {}};
    for (const auto& [key, value] : parameters) {
        const auto name = nb::cast<std::string>(key);
        const auto given = nb::borrow(value);
        if (nb::isinstance<nb::str>(given))
            spec.parameters.formulas[name] = nb::cast<std::string>(given);
        else
            spec.parameters[name] = number_of(name.c_str(), given);
    }
    return space_of(spec);
}

// What __new__ makes it again of, for pickle.
auto arguments_of(const Space& space) {
    nb::dict parameters;
    for (const auto& [name, value] : space.spec.parameters) parameters[name.c_str()] = value;
    for (const auto& [name, formula] : space.spec.parameters.formulas) parameters[name.c_str()] = formula;
    return std::pair(std::tuple(space.spec.metric), parameters);
}

std::string text_of(const Space& space) {
    Scene scene;
    scene.spacetime = space.spec;
    return exact_scene_text(scene, {});
}

double checked_radius(const Spacetime& metric, const nb::object& given) {
    const double r = number_of("r", given);
    if (std::isfinite(r) && camera_can_be(metric, r)) return r;
    throw Refused(bad_key("r", fmt::format("{} is out of range", r), allowed_falling_radii(metric)));
}

double checked_theta(const nb::object& given) {
    const double theta = number_of("theta", given);
    if (theta >= 0.0 && theta <= M_PI) return theta;
    throw Refused(bad_key("theta", fmt::format("{} is out of range", theta), "theta in [0, pi]"));
}

nb::object circular(const Space& space, const nb::object& r) {
    const auto orbit = circular_orbit(*space.metric, checked_radius(*space.metric, r));
    if (!orbit) return nb::none();
    nb::dict numbers;
    numbers["ut_up"] = orbit->u_t, numbers["omega"] = orbit->omega;
    numbers["u_t"] = orbit->u_t;  // its name before
    numbers["energy"] = orbit->energy, numbers["momentum"] = orbit->momentum;
    return numbers;
}

nb::dict photon(const Space& space, const nb::object& given_theta, const nb::object& given_psi) {
    const double theta = checked_theta(given_theta), psi = number_of("psi", given_psi);
    if (!(psi >= 0.0 && psi <= M_PI))
        throw Refused(bad_key("psi", fmt::format("{} is out of range", psi), "psi in [0, pi]"));
    const PhotonOrbit orbit = value_of(photon_orbit(*space.metric, theta, psi));
    nb::dict numbers;
    numbers["r"] = orbit.r, numbers["lambda"] = orbit.lambda, numbers["eta"] = orbit.eta;
    numbers["gamma"] = orbit.gamma, numbers["drag"] = orbit.drag;
    numbers["azimuth"] = orbit.azimuth, numbers["delay"] = orbit.delay;
    return numbers;
}

std::optional<double> shadow(const Space& space, const nb::object& r) {
    CameraSpec camera;
    camera.r = checked_radius(*space.metric, r);
    return camera_numbers(*space.metric, camera).shadow;
}

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::device::cpu>;

// Light from infinity to infinity: the angle that the reference's ray sweeps, less the half turn of a straight one.
auto deflection(const Space& space, const Numbers& impact, const nb::object& progress) {
    const Spacetime& metric = *space.metric;
    if (metric.spherical() == nullptr)
        throw Refused(
            bad_key("q", "a ray about a rotating hole needs more than these", "r, theta, phi, n_r, n_theta, n_phi"));
    constexpr double kFar = 1e30;  // r_s
    Scene scene;
    scene.spacetime = space.spec;
    std::vector<double> angles(impact.shape(0), kNotANumber);
    const double unit = metric.length_unit(), least = 1 / kFar;
    run(progress, [&](Watch& watch) -> Status {
        const Advance advance = watch.listener().progress("rays", static_cast<long long>(angles.size()));
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double b = impact.data()[static_cast<std::int64_t>(i) * impact.stride(0)];
            if (!(b >= 1e-9 && b <= 1e15))
                return Error{ErrorKind::kBadInput, fmt::format("{} is out of range", b), "[1e-9, 1e15]", "impact",
                             fmt::format("impact[{}]", i)};
            RayQuery query;
            query.orbit = ReducedRay{1.0 / (b * unit), metric.by_proper_length() ? kFar : least, 1};
            TRY(record, reference::trace_ray(scene, query));
            if (record->fate == Fate::kEscaped || record->fate == Fate::kOtherSide) angles[i] = record->angle - M_PI;
            advance(1);
        }
        return Done{};
    });
    const std::size_t count = angles.size();
    return array_of(std::move(angles), {count});
}

void add_identity(nb::class_<Space>& spacetime) {
    spacetime.def("__getnewargs_ex__", arguments_of)
        .def(
            "__eq__", [](const Space& a, const Space& b) { return a.spec == b.spec; }, nb::is_operator())
        .def("__hash__", [](const Space& s) { return std::hash<std::string>()(text_of(s)); })
        .def("__repr__", [](const Space& s) { return fmt::format("<nullscope.Spacetime {}>", s.metric->name()); });
}

template <std::optional<double> Landmarks::*member>
std::optional<double> landmark(const Space& space) {
    return landmarks_of(*space.metric).*member;
}

std::vector<std::string> metrics() {
    std::vector<std::string> names;
    for (const MetricEntry& entry : metric_registry()) names.emplace_back(entry.key);
    return names;
}

}  // namespace

void add_spacetime(nb::module_& m) {
    nb::class_<Space> spacetime(m, "Spacetime",
        "A metric. Lengths in r_s, of wormholes in the scene's unit; None where a metric has no such "
        "thing. About a rotating hole orbits are those in the equatorial plane.");
    spacetime
        .def(nb::new_(
                 [](const nb::object& metric, const nb::kwargs& parameters) { return make_space(metric, parameters); }),
             nb::arg("metric").none() = "schwarzschild", nb::arg("parameters"),
             "By its name in scene files and its parameters: Spacetime(\"kerr\", spin=0.9).")
        .def_prop_ro_static(
            "metrics", [](const nb::handle&) { return metrics(); }, "The names of all metrics.")
        .def_prop_ro(
            "name", [](const Space& s) { return std::string(s.metric->name()); }, "Its name in scene files.")
        .def_prop_ro("horizon", landmark<&Landmarks::horizon>, "Radius of the outer horizon, r_s.")
        .def_prop_ro("photon_orbit", landmark<&Landmarks::photon_orbit>,
                     "Radius of the circular orbit of light, with the rotation, r_s.")
        .def_prop_ro("isco", landmark<&Landmarks::isco>,
                     "Radius of the innermost stable circular orbit, with the rotation, r_s.")
        .def_prop_ro("retrograde_photon_orbit", landmark<&Landmarks::retrograde_photon_orbit>,
                     "The same against the rotation; None without one.")
        .def_prop_ro("retrograde_isco", landmark<&Landmarks::retrograde_isco>,
                     "The same against the rotation; None without one.")
        .def_prop_ro("critical_impact", landmark<&Landmarks::critical_impact>,
                     "Impact parameter of the light that spirals to the photon sphere, r_s.")
        .def_prop_ro(
            "surface", [](const Space& s) { return s.metric->surface_radius(); }, "Radius of a star, r_s.")
        .def_prop_ro(
            "length_unit", [](const Space& s) { return s.metric->length_unit(); },
            "What ray data count lengths in: the throat's radius of wormholes, else 1.")
        .def_prop_ro(
            "camera_range",
            [](const Space& s) {
                const RadiusRange range = s.metric->camera_range();
                return std::pair(range.low, range.high == kAnyRadius ? HUGE_VAL : range.high);
            },
            "The open interval of radii at which a camera can be at rest, r_s.")
        .def(
            "metric",
            [](const Space& s, const nb::object& r, const nb::object& theta) {
                return array_of(s.metric->metric(checked_radius(*s.metric, r), checked_theta(theta)));
            },
            nb::arg("r").none(), nb::arg("theta").none() = M_PI / 2,
            "g_{mu nu}, shape (4, 4), in (t, r, theta, phi), signature (-, +, +, +), r_s = c = 1.")
        .def(
            "inverse_metric",
            [](const Space& s, const nb::object& r, const nb::object& theta) {
                return array_of(s.metric->inverse_metric(checked_radius(*s.metric, r), checked_theta(theta)));
            },
            nb::arg("r").none(), nb::arg("theta").none() = M_PI / 2, "g^{mu nu}, shape (4, 4).")
        .def("circular_orbit", circular, nb::arg("r").none(),
             "The circular geodesic at r in the equatorial plane, towards growing phi: ut_up = u^t = dt/dtau, omega = "
             "dphi/dt "
             "in "
             "c/r_s, energy and momentum (r_s c) per rest mass. None where there is none.")
        .def("spherical_photon_orbit", photon, nb::arg("theta").none() = M_PI / 2, nb::arg("psi").none() = 0.0,
             "The orbit of light of constant r that crosses the polar angle theta at the angle psi from e_phi, rad, as "
             "Carter's observer sees it: r, lambda and eta (r_s), Lyapunov exponent gamma, drag and azimuth (rad) and "
             "delay (r_s/c) of a half orbit.")
        .def("shadow", shadow, nb::arg("r").none(),
             "Angular radius of the shadow seen at rest at r, rad; None about a rotating hole (Observer.shadow_size).");
    add_identity(spacetime);
    m.def(
        "spacetime_of", [](const Scene& scene) { return space_of(scene.spacetime); }, nb::arg("scene"));
    m.def("deflection", deflection, nb::arg("spacetime"), nb::arg("impact"), nb::arg("progress").none() = nb::none());
}

}  // namespace nullscope::python
