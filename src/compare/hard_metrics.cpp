#include "compare/hard_parts.h"

#include <cmath>
#include <string>

#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kStandoff = 1 + 1e-5;  // least radius of a camera over that of a star (spacetime/neutron_star.h)
// In a tube the ray along the rim winds without end, and next to merging photon spheres 1e3 rad, all of that within 1e-9 rad of the
// rim: no pixel's middle on it, for a screen error is a difference of rays 1e-6 rad apart (docs/hard-cases.md).
constexpr double kAside = 2e-3;

// A metric, and where rays divide in it, for the directions of cases.
struct HardPlace {
    std::string metric, label;
    std::map<std::string, double> parameters;
    double photon_r;  // of the photon sphere; wormholes: 0; a star outside of it: its surface
    double least;     // horizon, or as near as a camera comes to a surface; wormholes: none
    bool disc;
    double aside = 0;  // rad, of looks across
};

Scene frame_of(const HardPlace& place, double r, double yaw, double fov) {
    return hard_view(hard_frame({place.metric, place.parameters}), r, yaw, fov);
}

// Half-angle of what rays from the sky do not reach, from the inward radial direction, seen at r outside: sin^2 = V(r)/V(dividing).
double dividing_angle(const HardPlace& p, double r) {
    const auto root_v = [&](double x) {
        if (p.metric == "ellis") return 1 / std::hypot(x, 1.0);
        if (const auto spacetime = make_spacetime(p.metric, p.parameters); p.metric == "dneg-wormhole")
            return (*spacetime)->spherical()->root_v(x);
        const double charge = p.parameters.contains("charge") ? p.parameters.at("charge") : 0.0;
        return std::sqrt(1 - 1 / x + 0.25 * charge * charge / (x * x)) / x;
    };
    return std::asin(root_v(r) / root_v(p.photon_r));
}

void critical(std::vector<HardCase>& list, const HardPlace& p) {
    constexpr double r = 20;
    const double angle = dividing_angle(p, r);
    for (const int k : {1, 3, 5, 7})
        for (const int side : {1, -1}) {
            const double off = std::pow(10.0, -k) * std::tan(angle);
            add_case(list, p.label, fmt::format("1e-{} {} the dividing ray", k, side > 0 ? "outside" : "inside"),
                     "the ray winds as often as float precision allows, or grazes",
                     frame_of(p, r, angle + side * off, off));
        }
}

void dividing_sphere(std::vector<HardCase>& list, const HardPlace& p) {
    for (const auto& [where, off] : {std::pair{"on", 0.0},
                                     {"1e-9 above", 1e-9},
                                     {"1e-9 below", -1e-9},
                                     {"1e-3 above", 1e-3},
                                     {"1e-3 below", -1e-3}}) {
        if (p.photon_r + off <= p.least) continue;
        for (const auto& [view, yaw] : kViews)
            add_case(list, p.label,
                     fmt::format("camera {} the {}, {}", where, p.least < 0 ? "throat" : "photon sphere", view),
                     "both kinds of rays meet, and chi0 = pi/2",
                     frame_of(p, p.photon_r + off, yaw + p.aside, 100 * kDegree));
    }
}

void extremes(std::vector<HardCase>& list, const HardPlace& p) {
    for (const int k : {2, 4, 6})
        for (const auto& [view, yaw] : kViews) {
            if (p.least > 0)
                add_case(
                    list, p.label,
                    fmt::format("1e-{} above the {}, {}", k,
                                p.metric == "neutron-star"                                         ? "surface"
                                : p.parameters.contains("charge") && p.parameters.at("charge") > 1 ? "innermost camera"
                                                                                                   : "horizon",
                                view),
                    "the sky closes to a cone, or the surface fills half of it",
                    frame_of(p, p.least * (1 + std::pow(10.0, -k)), yaw + p.aside, 100 * kDegree));
            else
                for (const int side : {1, -1})
                    add_case(list, p.label, fmt::format("l = {}1e{}, {}", side > 0 ? "" : "-", k, view),
                             "far on either side", frame_of(p, side * std::pow(10.0, k), yaw, 60 * kDegree));
        }
    add_case(list, p.label, "zeta0 = 1e-6, at its edge", "rays of interest are nearly radial",
             frame_of(p, 1e6, 0, 6 * dividing_angle(p, 1e6)));
    add_motions(list, p.label, frame_of(p, 6, 0, 90 * kDegree), {{-0.9, 0, 0}, {0, 0.3, 0.9}, {0.999, 0, 0}});
    if (!p.disc) return;
    for (const double inner : {p.photon_r, 1.02 * p.least}) {
        Scene scene = frame_of(p, 20, 0, 30 * kDegree);
        scene.camera.theta = 1.4;
        scene.disc = ring(inner, 6);
        add_case(list, p.label, fmt::format("disc from {:.4g}", inner), "its images pile up at the critical ray",
                 scene);
    }
}

}  // namespace

std::vector<HardCase> hard_metric_cases() {
    const std::string charged = "reissner-nordstrom";
    const double s = std::sqrt(0.75), sphere = 0.25 * (3 + std::sqrt(1 + 8 * s * s)),  // of Q/M = 0.5
        naked_sphere = 0.25 * (3 + std::sqrt(1 - 8 * 0.002001));
    const std::vector<HardPlace> places = {
        {charged, "charge 0.5", {{"charge", 0.5}}, sphere, 0.5 * (1 + s), true},
        {charged, "extremal hole", {{"charge", 1.0}}, 1.0, 0.5, true},
        {charged, "charge just naked", {{"charge", 1.001}}, naked_sphere, naked_sphere, false},
        {charged,
         "charge where photon spheres merge",
         {{"charge", std::sqrt(1.125)}},
         0.75,
         0.75 * (1 + 1e-7),
         false,
         kAside},
        {charged, "naked charge of 1.2", {{"charge", 1.2}}, 0.96, 0.1, false},
        {"neutron-star", "star of 1.2 r_s", {{"radius", 1.2}}, 1.5, 1.2 * kStandoff, false},
        {"neutron-star", "star of 2.5 r_s", {{"radius", 2.5}}, 2.5, 2.5 * kStandoff, false},
        {"ellis", "Ellis throat", {}, 0.0, -1e300, false},
        {"dneg-wormhole", "wormhole of the film", {}, 0.0, -1e300, false, kAside},
        {"dneg-wormhole", "long wormhole", {{"length", 2.0}, {"lensing_width", 0.5}}, 0.0, -1e300, false, kAside},
    };
    std::vector<HardCase> list;
    for (const HardPlace& place : places) {
        critical(list, place);
        dividing_sphere(list, place);
        extremes(list, place);
    }
    return list;
}

}  // namespace nullscope
