// The reference against a second formulation (kerr_schild.h) that shares nothing with it: named hard rays and random ones.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "proof/kerr_schild.h"
#include "proof/settings.h"
#include "reference/reference.h"
#include "spacetime/registry.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using namespace nullscope::proof;

// Roundings of the answer and of each input, an input's counted as often as the answer multiplies it: the reference is a chain
// of some ten operations; the integration, in 64 bits of mantissa and with steps good to 1e-18, adds less than one of its roundings.
constexpr double kSecondFormulationRoundings = 16;
constexpr double kSecondFormulationEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kCrossings = 8;
constexpr double kCriticalImpact2 = 6.75;  // in r_s^2

struct SecondFormulationCase {
    std::string name;
    Scene scene;
    RayQuery query;
};

// How much an answer changes by a relative change of its inputs r and n_t (the tangent of the view direction), by differences
// of the second formulation.
struct SecondFormulationBundle {
    SecondFormulationBundle(const KerrSchildMetric& metric, const RayQuery& asked) {
        const LongQuery query = long_query(asked);
        const LongVec n = query.n;
        const Long across2 = (n.y * n.y + n.z * n.z) / (n.x * n.x + n.y * n.y + n.z * n.z);
        const Long r = 1 + query.r_minus_1, w = std::sqrt(1 / r), sine2 = across2;
        Long room = 1;  // how far, relatively, the critical ray is: the step must stay below
        if (metric.mass != 0) {
            const bool rain = asked.frame == LocalFrame::kRain;
            const Long cosine = n.x / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z),
                       energy2 = (1 + w * cosine) * (1 + w * cosine);
            const Long impact2 = r * r * sine2 / (rain ? energy2 : query.r_minus_1 / r);
            room = std::min(Long(1), std::fabs(impact2 / Long(kCriticalImpact2) - 1));
        }
        step = 1e-6L * std::max(room, 1e-11L);
        here = integrate(metric, query, kCrossings);
        LongQuery changed = query;
        changed.r_minus_1 += step * std::min(r, std::fabs(query.r_minus_1) * 1e3L);
        r_share = r / std::min(r, std::fabs(query.r_minus_1) * 1e3L);
        by_r = integrate(metric, changed, kCrossings);
        changed = query;
        changed.n.y *= 1 + step, changed.n.z *= 1 + step;
        by_n = integrate(metric, changed, kCrossings);
    }
    template <class Output>
    double roundings(const Output& output, Long own) const {
        if (by_r.fate != here.fate || by_n.fate != here.fate) return std::numeric_limits<double>::infinity();
        const Long y = output(here);
        return static_cast<double>((r_share * std::fabs(output(by_r) - y) + std::fabs(output(by_n) - y)) / step + own);
    }
    IntegratedRay here, by_r, by_n;
    Long step, r_share;
};

struct Figures {
    double angle = 0, direction = 0, delay = 0, crossing = 0;
    int rays = 0, crossings = 0, escaped = 0, captured = 0, steps = 0;
};

double judge(const std::string& what, double error, double roundings) {
    CAPTURE(what);
    CAPTURE(error);
    CAPTURE(roundings);
    const double ratio = error == 0 ? 0 : error / (kSecondFormulationRoundings * kSecondFormulationEpsilon * roundings);
    CHECK(ratio <= 1);
    return ratio;
}
void keep(double& most, double ratio) { most = std::max(most, ratio); }

void check(const SecondFormulationCase& c, Figures& figures) {
    const auto metric = kerr_schild_metric(c.scene.spacetime);
    REQUIRE_MESSAGE(metric, "kerr_schild.cpp does not know this metric yet: " << c.scene.spacetime.metric);
    const auto record = reference::trace_ray(c.scene, c.query, kCrossings);
    const std::string ray =
        fmt::format("{}: seed {}, r = {:.17g}, theta = {:.17g}, phi = {:.17g}, n = ({:.17g}, {:.17g}, {:.17g}), {}",
                    c.name, seed(), c.query.r, c.query.theta, c.query.phi, c.query.n.x, c.query.n.y, c.query.n.z,
                    c.query.frame == LocalFrame::kRain ? "rain" : "static");
    CAPTURE(ray);
    REQUIRE(record);
    const SecondFormulationBundle bundle(*metric, c.query);
    const IntegratedRay& exact = bundle.here;
    ++figures.rays;
    figures.steps = std::max(figures.steps, exact.steps);
    CHECK(record->fate == exact.fate);
    if (record->fate != exact.fate) return;
    figures.escaped += exact.fate == Fate::kEscaped;
    figures.captured += exact.fate == Fate::kCaptured;
    if (std::isfinite(record->angle)) {
        const auto angle = [](const IntegratedRay& r) { return r.angle; };
        const double roundings = bundle.roundings(angle, 1 + exact.angle);
        keep(figures.angle, judge("angle", static_cast<double>(std::fabs(record->angle - exact.angle)), roundings));
        if (exact.fate == Fate::kEscaped) {
            // theta_inf and phi_inf as the place on the sky, where both are smooth.
            const Long st = std::sin(Long(record->theta_inf));
            const Long dx = st * std::cos(Long(record->phi_inf)) - exact.direction.x,
                       dy = st * std::sin(Long(record->phi_inf)) - exact.direction.y,
                       dz = std::cos(Long(record->theta_inf)) - exact.direction.z;
            const Long vx = record->sky.x - exact.direction.x, vy = record->sky.y - exact.direction.y,
                       vz = record->sky.z - exact.direction.z;
            const double azimuth = std::abs(record->phi_inf);  // with its windings a number of many turns
            keep(figures.direction,
                 judge("theta_inf, phi_inf", static_cast<double>(std::sqrt(dx * dx + dy * dy + dz * dz)),
                       roundings + 1 + azimuth));
            keep(figures.direction,
                 judge("sky", static_cast<double>(std::sqrt(vx * vx + vy * vy + vz * vz)), roundings + 1));
            const auto delay = [](const IntegratedRay& r) { return r.delay; };
            if (c.scene.spacetime.metric != "formula")  // of which the reference knows no delay
                keep(figures.delay, judge("delay", static_cast<double>(std::fabs(record->delay - exact.delay)),
                                          bundle.roundings(delay, 1 + std::fabs(exact.delay))));
        }
    }
    if (!std::isfinite(record->angle)) return;  // has ended where it starts: nothing is listed
    CHECK(record->crossings.size() == exact.crossings.size());
    const std::size_t common = std::min(
        {record->crossings.size(), exact.crossings.size(), bundle.by_r.crossings.size(), bundle.by_n.crossings.size()});
    for (std::size_t k = 0; k < common; ++k) {
        const auto& crossing = exact.crossings[k];
        const auto& found = record->crossings[k];
        const auto r = [k](const IntegratedRay& i) { return i.crossings[k].r; };
        const double roundings = bundle.roundings(r, crossing.r + (1 + crossing.angle) * std::fabs(crossing.slope));
        keep(figures.crossing, judge("crossing, r", static_cast<double>(std::fabs(found.r - crossing.r)), roundings));
        const Long dx = std::cos(Long(found.phi)) - crossing.place.x / crossing.r,
                   dy = std::sin(Long(found.phi)) - crossing.place.y / crossing.r;
        keep(figures.crossing,
             judge("crossing, phi", static_cast<double>(std::sqrt(dx * dx + dy * dy)), 1 + std::abs(found.phi)));
        ++figures.crossings;
    }
}

void check_all(const std::string& title, const std::vector<SecondFormulationCase>& cases) {
    Figures f;
    for (const SecondFormulationCase& c : cases) check(c, f);
    fmt::print(
        "{}: {} rays ({} escaped, {} captured, {} crossings; {} steps at most); largest error over bound: angle "
        "{:.2f}, "
        "direction {:.2f}, delay {:.2f}, crossings {:.2f}\n",
        title, f.rays, f.escaped, f.captured, f.crossings, f.steps, f.angle, f.direction, f.delay, f.crossing);
}

SecondFormulationCase ray(std::string name, double r, double theta, double phi, Vec3 n,
                          LocalFrame frame = LocalFrame::kStatic) {
    SecondFormulationCase c;
    c.name = std::move(name);
    c.query = {r, theta, phi, n, frame, {}, {}};
    return c;
}
// Off the critical direction by a part of its sine; bearing: of the motion, from southward to eastward.
SecondFormulationCase near_critical(double r, double part, double bearing) {
    const double sine = std::sqrt(6.75 * (r - 1) / r) / r * (1 + part), cosine = std::sqrt(1 - sine * sine);
    return ray(fmt::format("critical {:+.0e}", part), r, 1.1, 0.4,
               {r > 1.5 ? -cosine : cosine, sine * std::cos(bearing), sine * std::sin(bearing)});
}

TEST_CASE("second formulation: named hard rays" * test::costly()) {
    std::vector<SecondFormulationCase> cases;
    for (const double part : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
        for (const int side : {-1, 1}) {
            cases.push_back(near_critical(10, side * part, 0.7));
            cases.push_back(near_critical(1.2, side * part, 2.0));
        }
    for (const double tilt : {1e-2, 1e-6, 1e-10})
        for (const int side : {-1, 1}) cases.push_back(ray("photon sphere", 1.5, 1.2, 0, {side * tilt, 0.6, 0.8}));
    for (const double r : {1.0001, 1.3, 1.5, 4.0, 1e3, 1e6}) {
        // From further away the integration's last digit of a direction misses the middle of the hole by more than the bound.
        if (r <= 1e3) cases.push_back(ray("straight out", r, 0.8, 2, {1, 0, 0}));
        if (r <= 1e3) cases.push_back(ray("straight in", r, 0.8, 2, {-1, 0, 0}));
        if (r != 1.5) cases.push_back(ray("transverse", r, 1.0, 5, {0, 0.8, -0.6}));
        cases.push_back(ray("over the pole", r, 0.3, 1, {0.5, -1, 0}));
        cases.push_back(ray("next to the pole", r, 0.3, 1, {0.5, -1, 1e-9}));
        cases.push_back(ray("from the pole", r, 0, 1, {0.3, 1, 0.2}));
        cases.push_back(ray("equatorial camera", r, M_PI / 2, 1, {-0.1, 1, 0.2}));
    }
    for (const double r : {0.2, 0.999, 1.001, 1.5, 20.0})
        for (const double alpha : {0.1, 1.0, 1.8, 2.5})
            cases.push_back(ray("raindrop", r, 1.9, 3, {std::cos(alpha), std::sin(alpha), 0.1}, LocalFrame::kRain));
    check_all("named rays", cases);
}

TEST_CASE("second formulation: random rays in every metric" * test::costly()) {
    Random random(seed());
    for (const MetricEntry& entry : metric_registry()) {
        if (!kerr_schild_metric(
                {std::string(entry.key), {}})) {  // stars and wormholes have no such chart: tests/vectors, tests/unit
            fmt::print("random, {}: not of Kerr-Schild form\n", entry.key);
            // Nor has a radius that is not areal; and of a rotating hole the reference is this formulation.
            const auto spacetime = *make_spacetime(std::string(entry.key), {});
            CHECK_FALSE((spacetime->can_have_disc() && spacetime->planar_rays()));
            continue;
        }
        std::vector<SecondFormulationCase> cases;
        for (int i = 0; i < tries(150); ++i) {
            SecondFormulationCase c;
            c.name = fmt::format("{} {}", entry.key, i);
            c.scene.spacetime.metric = entry.key;
            for (const MetricParameter& p : entry.parameters)
                c.scene.spacetime.parameters[std::string(p.name)] = random.between(p.low, p.high);
            const double cosine = random.between(-1, 1), bearing = random.between(0, 2 * M_PI),
                         sine = std::sqrt(1 - cosine * cosine);
            c.query.frame = random.unit() < 0.25 ? LocalFrame::kRain : LocalFrame::kStatic;
            c.query.r = c.query.frame == LocalFrame::kRain
                            ? random.log_between(entry.parameters.empty() ? 0.1 : 1.001, 100)
                            : 1 + random.log_between(1e-3, 1e4);
            // Nothing rains to where a charge repels: A above 1.
            const auto spacetime = *make_spacetime(std::string(entry.key), c.scene.spacetime.parameters);
            if (c.query.frame == LocalFrame::kRain && spacetime->lapse_squared(c.query.r) > 1) c.query.r += 100;
            c.query.theta = std::acos(random.between(-1, 1));
            c.query.phi = random.between(-M_PI, M_PI);
            c.query.n = {cosine, sine * std::cos(bearing), sine * std::sin(bearing)};
            cases.push_back(c);
        }
        check_all(fmt::format("random, {}", entry.key), cases);
    }
}

}  // namespace
