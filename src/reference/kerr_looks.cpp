// Places along a step of a ray about a rotating hole, for whoever looks for bodies and matter on it.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "reference/kerr_lanes.h"
#include "reference/kerr_trace.h"

namespace nullscope::reference {
namespace {

// of its radius: how near to it a ray is shown; nearer, rounding turns the azimuth by 1e-7 rad and more
constexpr double kAboveHorizon = 1e-9;
constexpr double kAxis = 1e-9;  // of the sine of the polar angle, within which that does not change
constexpr int kHalvings = 40;   // of a step through the horizon: beyond them is rounding

}  // namespace

// One step's: the interpolant is made where somebody asks for it.
struct KerrTrace::Looks {
    const KerrTrace& trace;
    Here from;
    State end;
    double taken;
    std::optional<Between> line{};

    KerrPlace at(double along) const {
        return trace.place_of(from, trace.stepped(from, along - from.along), along - from.along);
    }
    Between::Known near(double along) {
        if (!line) line = trace.between(from, end, taken);
        return (*line)((along - from.along) / taken);
    }
    KerrMotion motion(double along) { return trace.motion_of(from, near(along).value, along - from.along); }
};

KerrPlace KerrTrace::place_of(const Here& from, const State& s, double length) const {
    const double au2 = (flow_.a * s[5]) * (flow_.a * s[5]), ratio = KerrFlow::round(s[2], au2).ratio, r = ratio / s[5];
    return {r, std::atan2(std::hypot(s[0], s[1]) / std::sqrt(ratio * ratio + au2), s[2] / ratio),
            azimuth(from, s, length, r), delay(from, s)};
}

// The chart's velocity, and what its azimuth and time are ahead.
KerrMotion KerrTrace::motion_of(const Here& from, const State& s, double length) const {
    const auto [x, p] = phase(from, s);
    const KerrChart::Pull pull = chart_.pull(from.leg.energy, x, p);
    const Vec3 v = p + pull.drift;
    const double r = chart_.radius(x), rising = chart_.rising(x, v), flat2 = x.x * x.x + x.y * x.y,
                 sense = from.leg.sense;
    const double cosine = x.z / r, sine = std::sqrt(flat2 / (r * r + flow_.a * flow_.a));
    const double turn = flat2 > 0 ? (x.x * v.y - x.y * v.x) / flat2 : 0;
    return {place_of(from, s, length), rising, (cosine * rising - v.z) / (r * std::max(sine, kAxis)),
            -sense * (turn - chart_.ahead_slope(r) * rising),
            -sense * (from.leg.energy + pull.delay - chart_.tortoise_slope(r) * rising)};
}

// By states at the places between, which are integrated together, and the slopes that they have.
KerrTrace::Between KerrTrace::between(const Here& from, const State& end, double taken) const {
    std::array<FlowTask<double>, Between::kPlaces> tasks{};
    std::array<FlowTask<double>*, Between::kPlaces> some{};
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        tasks[i].ray = flow_ray(from), tasks[i].start = from.state, tasks[i].length = Between::kAt[i] * taken;
        some[i] = &tasks[i];
    }
    flow_steps(flow_, some.data() + 1, Between::kPlaces - 2);
    tasks.front().end = from.state, tasks.back().end = end;
    std::array<Between::Known, Between::kPlaces> known{};
    for (std::size_t i = 0; i < known.size(); ++i) {
        known[i] = {tasks[i].end, slope(from, tasks[i].end)};
        for (double& by_part : known[i].slope) by_part *= taken;
    }
    return Between(known);
}

// sin(theta) e^{i(phi~ - ...)} by (x + iy)/(r + ia), without angles.
KerrGlance KerrTrace::glance(const Here& from, const Between::Known& there, double taken, bool timed) const {
    const State &s = there.value, &d = there.slope;
    const double u = s[5], au = flow_.a * u, ratio = KerrFlow::round(s[2], au * au).ratio, r = ratio / u,
                 across = ratio * ratio + au * au, cosine = s[2] / ratio;
    const double co = (ratio * s[0] + au * s[1]) / across, si = (ratio * s[1] - au * s[0]) / across,
                 sine = std::sqrt(co * co + si * si);
    const double turn = from.leg.phi + from.leg.sense * chart_.drag_ahead(r), ct = std::cos(turn), st = std::sin(turn);
    const Vec3 n{s[0], s[1], s[2]}, motion = (Vec3{d[0], d[1], d[2]} - d[5] / u * n) / (u * taken);
    const double rising = chart_.rising(n / u, motion), sense = from.leg.sense;
    return {r,
            {ct * co + sense * st * si, st * co - sense * ct * si, cosine},
            timed ? delay(from, s) : 0,
            rising,
            (cosine * rising - motion.z) / (r * std::max(sine, kAxis))};
}

// What of a step is outside the horizon.
void KerrTrace::show(const State& end, double taken) const {
    const auto outside = [this](const State& s) { return radius(s) > outer_ * (1 + kAboveHorizon); };
    const bool begins = outside(here_.state), ends = outside(end);
    if (!begins && !ends) return;
    const double from = here_.along;
    const auto looks = std::make_shared<Looks>(Looks{*this, here_, end, taken});
    KerrStep step{from,
                  from + taken,
                  {},
                  {},
                  0,
                  [looks](double along) { return looks->at(along); },
                  [looks](double along) {
                      return looks->trace.place_of(looks->from, looks->near(along).value, along - looks->from.along);
                  },
                  [looks](double along, bool timed) {
                      return looks->trace.glance(looks->from, looks->near(along), looks->taken, timed);
                  },
                  [looks](double along) { return looks->motion(along); }};
    if (begins != ends) {
        double out = begins ? 0 : taken, in = taken - out;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (out + in);
            (outside(stepped(here_, middle)) ? out : in) = middle;
        }
        (begins ? step.to : step.from) = from + out;
    }
    step.begin = begins ? place_of(here_, here_.state, 0) : step.at(step.from);
    step.end = ends ? place_of(here_, end, taken) : step.at(step.to);
    const double before = slope(here_, here_.state)[5], after = slope(here_, end)[5],
                 u = std::max(here_.state[5], end[5]);
    const bool turns = before > 0 && after < 0;  // no step has an arc of more than a radian
    step.nearest = std::max(0.0, (turns ? 0.5 : 1.0) / u - std::abs(flow_.a));
    (*watch_)(step);
}

}  // namespace nullscope::reference
