#include <fmt/format.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>

#include "module/arrays.h"
#include "module/call.h"
#include "module/module.h"
#include "observer/critical_curve.h"
#include "observer/landmarks.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/worldline.h"
#include "scenefile/scene_writer.h"

namespace nullscope::python {
namespace {

// A camera's place and motion.
struct Someone {
    Scene scene;
    Space space;
    CameraNumbers numbers;
};

Someone someone_of(const Scene& scene) {
    const Space space = space_of(scene.spacetime);
    value_of(observer_of(*space.metric, scene.camera));
    return {scene, space, camera_numbers(*space.metric, scene.camera)};
}

// Of its scene what it depends on.
std::string text_of(const Someone& one) {
    Scene scene;
    scene.spacetime = one.scene.spacetime, scene.camera = one.scene.camera, scene.light = one.scene.light;
    return exact_scene_text(scene, {});
}

auto tetrad(const Someone& one) {
    const TetradPair pair = value_of(ingoing_tetrad_pair(*one.space.metric, one.scene.camera));
    Matrix4 sum = pair.high;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum[i][j] += pair.low[i][j];
    return array_of(sum);
}

Worldline fall(const Someone& one, const nb::object& given) {
    const double duration = number_of("duration", given);
    if (!(duration > 0.0 && duration <= 1e9))
        throw Refused(bad_key("duration", fmt::format("{} is out of range", duration), "(0, 1e9]"));
    return value_of(Worldline::make(one.space.metric, one.scene.camera, duration));
}

constexpr std::size_t kPlaceColumns = 5;

// Columns tau, time, r, theta, phi.
auto places(const Worldline& line, const nb::object& given) {
    nb::ndarray<const double, nb::ndim<1>, nb::device::cpu> times;
    if (!nb::try_cast(given, times)) throw Refused(bad_key("tau", "no such array", "float64, shape (n,)"));
    std::vector<double> values;
    values.reserve(times.shape(0) * kPlaceColumns);
    for (std::size_t i = 0; i < times.shape(0); ++i) {
        const double tau = times.data()[static_cast<std::int64_t>(i) * times.stride(0)];
        if (!(tau >= 0.0 && tau <= line.last()))
            throw Refused(bad_key(fmt::format("tau[{}]", i), fmt::format("{} is out of range", tau),
                                  fmt::format("[0, {:.17g}]", line.last())));
        const CameraSpec camera = line.at(tau);
        values.insert(values.end(), {tau, line.clock(tau), camera.r, camera.theta, line.azimuth(tau)});
    }
    return array_of(std::move(values), {times.shape(0), kPlaceColumns});
}

auto curve(const Someone& one) {
    std::vector<nb::ndarray<nb::numpy, double>> lines;
    for (const PictureLine& line : critical_curve(*one.space.metric, one.scene.camera, one.scene.light)) {
        std::vector<double> values;
        for (const auto& [x, y] : line) values.insert(values.end(), {x, y});
        lines.push_back(array_of(std::move(values), {line.size(), 2}));
    }
    return lines;
}

const char* end_name(const Worldline& line) {
    constexpr const char* kNames[] = {"open", "singularity", "surface"};
    return kNames[static_cast<int>(line.end())];
}

template <auto member>
auto number(const Someone& one) {
    return one.numbers.*member;
}

template <double CameraSpec::*member>
double place(const Someone& one) {
    return one.scene.camera.*member;
}

}  // namespace

void add_observer(nb::module_& m) {
    nb::class_<Worldline>(m, "Worldline", "A camera in free fall, a geodesic in proper time; Observer.fall() makes it.")
        .def_prop_ro("last", &Worldline::last, "Greatest proper time, r_s/c: short of a singularity by 1e-5.")
        .def_prop_ro("end", end_name, "How it ends: \"open\", \"singularity\" or \"surface\".")
        .def_prop_ro("end_time", &Worldline::end_time, "Proper time of the end itself, r_s/c.")
        .def_prop_ro("horizon_time", &Worldline::horizon_time, "Proper time at the outer horizon, r_s/c, or None.")
        .def_prop_ro("energy", &Worldline::energy, "Per rest mass.")
        .def("places", places, nb::arg("tau").none(),
             "At proper times tau, shape (n,): shape (n, 5), columns tau, time (r_s/c), r (r_s), theta, phi (rad). phi "
             "keeps whole turns. About a hole, time is v - r of ingoing coordinates, 0 at the start of one who falls, "
             "and "
             "phi about a rotating one their azimuth: both finite at the horizon. Where there is no hole, time is t.");
    nb::class_<Someone>(m, "Observer",
                        "The observer who holds a scene's camera; nullscope.Observer(scene) makes it. Lengths in r_s, "
                        "times in r_s/c, angles in rad; None where there is no such thing.")
        .def(nb::new_([](const nb::object& scene) { return someone_of(scene_of(scene)); }), nb::arg("scene").none(),
             "scene: whatever nullscope.scene() takes; its metric and camera are used.")
        .def_prop_ro(
            "kind", [](const Someone& o) { return observer_name(o.scene.camera.observer); },
            "The word of scene files: \"static\", \"rain\", ...")
        .def_prop_ro(
            "spacetime", [](const Someone& o) { return o.space; }, "Where it is.")
        .def_prop_ro("r", place<&CameraSpec::r>, "Radius, r_s.")
        .def_prop_ro("theta", place<&CameraSpec::theta>, "Polar angle, rad.")
        .def_prop_ro("phi", place<&CameraSpec::phi>, "Azimuth, rad.")
        .def_prop_ro(
            "velocity",
            [](const Someone& o) {
                const Vec3 v = value_of(observer_of(*o.space.metric, o.scene.camera)).velocity;
                return std::array{v.x, v.y, v.z};
            },
            "Along e_r, e_theta, e_phi of its kind's radial frame, c.")
        .def_prop_ro("lapse", number<&CameraNumbers::lapse>, "dtau/dt of an observer there without angular momentum.")
        .def_prop_ro("clock_rate", number<&CameraNumbers::clock_rate>, "dtau/dt of this observer.")
        .def_prop_ro("shadow", number<&CameraNumbers::shadow>,
                     "Angular radius of the shadow, rad, seen at rest there; None about a rotating hole.")
        .def_prop_ro("shadow_size", number<&CameraNumbers::shadow_size>,
                     "About a rotating hole: width and height of the shadow, rad, seen without angular momentum there.")
        .def_prop_ro("orbit_speed", number<&CameraNumbers::orbit_speed>,
                     "Of a circular geodesic there, by observers at rest, c.")
        .def_prop_ro("orbit_period", number<&CameraNumbers::orbit_period>, "Of the same, coordinate time, r_s/c.")
        .def_prop_ro("tetrad", tetrad, nb::rv_policy::automatic,
                     "Shape (4, 4), rows e_0 (the four-velocity), right, up, backward; columns (v, r, theta, phi), "
                     "ingoing coordinates, v = t + r_*. Orthonormal to 1e-12, a double's rounding times gamma^2.")
        .def("critical_curve", curve,
             "The critical curve in the camera's picture: list of lines, shape (n, 2), column and row, px from the "
             "upper left corner.")
        .def("fall", fall, nb::arg("duration").none(),
             "The free fall from here for a proper time up to `duration`, r_s/c: a Worldline.")
        .def("__getnewargs__", [](const Someone& o) { return std::tuple(o.scene); })
        .def(
            "__eq__", [](const Someone& a, const Someone& b) { return text_of(a) == text_of(b); }, nb::is_operator())
        .def("__hash__", [](const Someone& o) { return std::hash<std::string>()(text_of(o)); })
        .def("__repr__", [](const Someone& o) {
            return fmt::format("<nullscope.Observer {} at r = {:g}>", observer_name(o.scene.camera.observer), o.scene.camera.r);
        });
}

}  // namespace nullscope::python
