#include "gradient/flow.h"

#include <fmt/format.h>

#include <cmath>

#include "spacetime/registry.h"

namespace nullscope {

LookedAlong looked_along(Vec3 n) {
    const Vec3 other = std::fabs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 aside = normalized(cross(n, other));
    return {n, aside, cross(n, aside)};
}

LaunchFrame::LaunchFrame(const Launch& from) : r(Number::variable(from.r, kSeedR)) {
    const Number theta = Number::variable(from.theta, kSeedTheta);
    sine = sin(theta), cosine = cos(theta);
    const double c = std::cos(from.phi), s = std::sin(from.phi);
    outward = {c * sine, s * sine, cosine}, southward = {c * cosine, s * cosine, -sine};
    eastward = {Number(-s), Number(c), Number(0.0)};
    view = from.view;
}

Triple turning(const LookedAlong& along) {
    const auto& [n, aside, across] = along;
    const auto part = [](double value, double by_aside, double by_across) {
        Number x(value);
        x.d[kSeedAside] = by_aside, x.d[kSeedAcross] = by_across;
        return x;
    };
    return {part(n.x, aside.x, across.x), part(n.y, aside.y, across.y), part(n.z, aside.z, across.z)};
}

RayState launched(const LaunchFrame& frame, const Number& w, const Number& southward, const Number& eastward) {
    RayState state;
    state[kU] = 1.0 / frame.r, state[kW] = w;
    for (std::size_t i = 0; i < 3; ++i) {
        state[kN + i] = frame.outward[i];
        state[kTurn + i] = southward * frame.southward[i] + eastward * frame.eastward[i];
    }
    return state;
}

Result<std::unique_ptr<Flow>> make_flow(const std::string& metric, const std::map<std::string, double>& parameters,
                                        const std::map<std::string, std::string>& formulas) {
    const auto number = [&](const char* name) {
        const auto found = parameters.find(name);
        return found == parameters.end() ? 0.0 : found->second;
    };
    if (metric == "minkowski") return make_hole_flow(0, 0, 0);
    for (const char* hole : {"schwarzschild", "reissner-nordstrom", "kerr", "kerr-newman"})
        if (metric == hole) return make_hole_flow(0.5, number("spin"), number("charge"));
    if (metric != "formula")
        return bad_input(fmt::format("no derivatives in metric {}", metric),
                         "schwarzschild, reissner-nordstrom, kerr, kerr-newman, formula, minkowski");
    MetricParameters given;
    given.formulas = formulas;
    TRY(spacetime, make_spacetime(metric, given));
    std::map<std::string, std::string> texts = formulas;
    texts.emplace("A", "1 - 1/r");
    return make_formula_flow(texts, (*spacetime)->horizon_radius());
}

}  // namespace nullscope
