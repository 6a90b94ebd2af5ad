// The reference about a rotating black hole from far away, against Carter's equations in Taylor series (taylor_kerr.h):
// cameras from 500 to 5e8 r_s, rays next to the shadow's edge and over it. At quick depth one ray in
// kPart of them.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "proof/settings.h"
#include "proof/taylor_kerr.h"
#include "reference/kerr_ray.h"
#include "support/costly.h"
#include "support/depth.h"

namespace {

using namespace nullscope;
using namespace nullscope::proof;
using reference::KerrRay;
using reference::KerrStart;
using Real50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Kerr = TaylorKerr<long double>;

constexpr int kRays = 384, kPart = 12;
constexpr std::array kSpins{0.1, 0.7, 0.998};
constexpr std::array kRadii{5e2, 5e3, 5e4, 5e5, 5e6, 5e7, 5e8};
// r_s: of the impact parameter, what kerr_ray.h states; rad, of a direction that nothing enlarges
constexpr double kSureOf = 4e-13;
constexpr double kSureOfTime = 1e-8;  // r_s/c, as kerr_ray.h; and
constexpr double kRoundings = 2;      // of what is as long as the way
constexpr double kRounding = 2.3e-16;
constexpr double kFarPlace = 10;         // r_s a radian and r_s, at least: how far a direction is carried to a crossing
constexpr double kNearPole = 1e-3;       // of a direction's sine, below which mu says nothing of it
constexpr double kSameConstant = 1e-14;  // of energy and angular momentum: some roundings of products
constexpr double kSameSeries = 1e-13;    // rad: 1e-19 of a long double, enlarged next to the axis
constexpr long double kNudge = 1e-2L;    // of a ray's neighbours, part of its distance to the edge

template <class Real>
typename TaylorKerr<Real>::Start taylor_start(double spin, const KerrStart& s, Real by_theta = 0, Real by_phi = 0) {
    return {Real(spin) / 2,
            Real(s.r),
            Real(s.theta),
            Real(s.direction.x),
            Real(s.direction.y) + by_theta,
            Real(s.direction.z) + by_phi};
}

// The angle from the hole's middle at which the shadow ends, in the direction psi of the sky.
long double edge(double spin, double r, double theta, long double psi) {
    long double dark = 0.5L / r, clear = 10 / static_cast<long double>(r);
    for (int i = 0; i < 80; ++i) {
        const long double middle = 0.5L * (dark + clear), s = std::sin(middle);
        const Kerr ray({spin / 2.0L, r, theta, -std::cos(middle), s * std::cos(psi), s * std::sin(psi)}, false);
        (ray.turns() ? clear : dark) = middle;
    }
    return clear;
}

// Half of the rays next to the edge, down to 1e-13 of its angle; half over twice the shadow.
KerrStart far_ray(double spin, double r, int i, Random& random) {
    const double theta = (i % 4 < 2 ? 45 : 80) * M_PI / 180;
    const long double psi = 2 * M_PI * random.unit(), limit = edge(spin, r, theta, psi);
    const double side = random.unit() < 0.5 ? -1 : 1, offset = random.log_between(1e-13, 0.1),
                 part = 2 * std::sqrt(random.unit());
    const long double beta = limit * (i % 2 == 0 ? 1 + side * static_cast<long double>(offset) : part);
    const double y = static_cast<double>(std::sin(beta) * std::cos(psi)),
                 z = static_cast<double>(std::sin(beta) * std::sin(psi));
    return {r, theta, 0, {-std::sqrt((1 - y) * (1 + y) - z * z), y, z}};
}

struct Direction {
    long double x, y, z;
};
Direction sky_of(const Kerr& ray) {
    const long double flat = std::sqrt((1 - ray.mu()) * (1 + ray.mu()));
    return {flat * std::cos(ray.phi()), flat * std::sin(ray.phi()), ray.mu()};
}
double apart(const Direction& a, const Direction& b) {
    return static_cast<double>(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
}

// What a ray's answers move by if its impact parameter does, per r_s: the sky's direction, the place and time of
// crossings, T.
struct Sway {
    double sky = 0, delay = 0;
    std::array<double, 2> place{}, crossing_delay{};
};
double place_apart(const Kerr::Crossing& a, const Kerr::Crossing& b) {
    return static_cast<double>(
        std::hypot(a.r * std::cos(a.phi) - b.r * std::cos(b.phi), a.r * std::sin(a.phi) - b.r * std::sin(b.phi)));
}
Sway sway_of(double spin, const KerrStart& start, const Kerr& here) {
    const long double beta = std::atan2(std::hypot(static_cast<long double>(start.direction.y), start.direction.z),
                                        -static_cast<long double>(start.direction.x));
    const long double distance =
        std::abs(beta - edge(spin, start.r, start.theta,
                             std::atan2(static_cast<long double>(start.direction.z), start.direction.y)));
    const long double nudge = kNudge * std::min(distance, beta), moved = nudge * start.r;
    Sway sway;
    for (const auto& [t, p] : {std::array{nudge, 0.0L}, std::array{0.0L, nudge}}) {
        const Kerr other(taylor_start<long double>(spin, start, t, p));
        if (!other.captured() && !here.captured()) {
            sway.sky = std::hypot(sway.sky, apart(sky_of(here), sky_of(other)) / static_cast<double>(moved));
            sway.delay = std::hypot(sway.delay, static_cast<double>((other.delay() - here.delay()) / moved));
        }
        for (std::size_t k = 0; k < 2 && k < here.crossings().size(); ++k) {
            if (other.crossings().size() <= k) {
                sway.place[k] = kNotANumber;  // a crossing that the neighbour has not: its sway has no end
                break;
            }
            const Kerr::Crossing &a = here.crossings()[k], &b = other.crossings()[k];
            sway.place[k] = std::hypot(sway.place[k], place_apart(a, b) / static_cast<double>(moved));
            sway.crossing_delay[k] =
                std::hypot(sway.crossing_delay[k], static_cast<double>((a.delay - b.delay) / moved));
        }
    }
    return sway;
}

// Whether the fate of a ray is sure: the same at an impact parameter that differs by kSureOf.
bool sure(double spin, const KerrStart& start) {
    const long double part = kSureOf / (start.r * std::hypot(start.direction.y, start.direction.z));
    const auto turns = [&](long double by) {
        return Kerr(taylor_start<long double>(spin, start, by * start.direction.y, by * start.direction.z), false)
            .turns();
    };
    return turns(part) == turns(-part);
}

struct Worst {
    int rays = 0, wrong = 0, unsure = 0, lost = 0;  // wrong: fates that are sure
    // b: a direction's error over its sway, r_s; the others over what is stated
    double b = 0, place = 0, time = 0;
};

// The errors of one ray over what is stated. Next to the axis a long double has not enough digits for 1 - mu^2: there,
// and wherever something is off, 50 are asked.
template <class Real>
Worst errors(double spin, const KerrStart& start, const KerrRay& ray, const Sway& sway) {
    const TaylorKerr<Real> exact(taylor_start<Real>(spin, start));
    Worst worst;
    const double whole = kRoundings * kRounding * start.r;
    const auto off = [](const Real& a, double b) { return static_cast<double>(a - b); };
    if (!exact.captured()) {
        const Real flat = sqrt((1 - exact.mu()) * (1 + exact.mu()));
        const double turned = off(exact.phi(), ray.phi_inf), risen = off(exact.mu(), ray.sky.z),
                     wide = static_cast<double>(flat);
        // Along the circle of latitude, and along the meridian, where mu changes by the sine of theta times as much.
        const double error =
            std::hypot(wide * turned, wide > kNearPole ? risen / wide : off(flat, std::hypot(ray.sky.x, ray.sky.y)));
        worst.b = error / std::max(sway.sky, 1.0);
        worst.time = std::abs(off(exact.delay(), ray.delay)) / (kSureOfTime + whole + kSureOf * sway.delay);
    }
    for (std::size_t k = 0; k < 2 && k < exact.crossings().size(); ++k) {
        if (ray.crossings.size() <= k) {
            ++worst.lost;
            break;
        }
        if (std::isnan(sway.place[k])) break;
        const auto& a = exact.crossings()[k];
        const double r = static_cast<double>(a.r),
                     apart = std::hypot(off(a.r, ray.crossings[k].r), r * off(a.phi, ray.crossings[k].phi));
        worst.place = std::max(worst.place, apart / (kSureOf * (sway.place[k] + kFarPlace * r)));
        worst.time = std::max(worst.time, std::abs(off(a.delay, ray.crossings[k].delay)) /
                                              (kSureOfTime + whole + kSureOf * sway.crossing_delay[k]));
    }
    return worst;
}

void judge(double spin, const KerrStart& start, const KerrRay& ray, Worst& all) {
    const Kerr exact(taylor_start<long double>(spin, start));
    ++all.rays;
    REQUIRE(exact.ended());
    if (ray.fate != (exact.captured() ? Fate::kCaptured : Fate::kEscaped)) {
        ++(sure(spin, start) ? all.wrong : all.unsure);
        return;
    }
    CHECK(std::abs(static_cast<double>(ray.l_z - exact.l())) < kSameConstant * std::max(1.0, std::abs(ray.l_z)));
    CHECK(std::abs(static_cast<double>(ray.energy / exact.energy() - 1)) < kSameConstant);
    const Sway sway = sway_of(spin, start, exact);
    Worst worst = errors<long double>(spin, start, ray, sway);
    if (!(worst.b < kSureOf && worst.place < 1 && worst.time < 1)) worst = errors<Real50>(spin, start, ray, sway);
    all.lost += worst.lost, all.b = std::max(all.b, worst.b);
    all.place = std::max(all.place, worst.place), all.time = std::max(all.time, worst.time);
}

}  // namespace

TEST_CASE("far kerr: no fate is wrong, and directions, crossings and times are what is stated, from 500 to 5e8 r_s" *
          test::costly()) {
    Random random(seed());
    const int rays = test::by_depth(kRays / kPart, kRays, kRays);
    for (const double spin : kSpins)
        for (const double r : kRadii) {
            Worst worst;
            for (int i = 0; i < rays; ++i) {
                const KerrStart start = far_ray(spin, r, i, random);
                judge(spin, start, reference::trace_kerr(spin, start, 2), worst);
            }
            fmt::print(
                "a = {:<5} r = {:.0e}: {} rays, {} wrong fates, {} at the edge, {} crossings lost, b {:.1e}, place "
                "{:.2f}, time {:.2f}\n",
                spin, r, worst.rays, worst.wrong, worst.unsure, worst.lost, worst.b, worst.place, worst.time);
            CHECK(worst.wrong == 0);
            CHECK(worst.lost == 0);
            CHECK(worst.b < kSureOf);
            CHECK(worst.place < 1);
            CHECK(worst.time < 1);
        }
}

// The same photon by ingoing components, as an observer of any motion gives it: of a camera without angular momentum.
reference::KerrPhoton photon_of(double spin, const KerrStart& start) {
    const long double a = spin / 2.0L, r = start.r, sine = std::sin(static_cast<long double>(start.theta)),
                      cosine = std::cos(static_cast<long double>(start.theta));
    const long double sigma = r * r + a * a * cosine * cosine, across = r * r + a * a, delta = r * r - r + a * a;
    const long double area = across * sigma + a * a * r * sine * sine, lapse = std::sqrt(delta * sigma / area),
                      girth = std::sqrt(area / sigma);
    const long double x = start.direction.x, y = start.direction.y, z = start.direction.z,
                      norm = std::sqrt(x * x + y * y + z * z);
    const long double p_t = norm / lapse, p_r = -x * std::sqrt(delta / sigma),
                      around = sine * a * r / area * p_t - z / girth;
    return {start.r,
            start.theta,
            start.phi + reference::kerr_azimuth_ahead(spin, start.r),
            {p_t + across / delta * p_r, p_r, -y / std::sqrt(sigma), around + sine * a / delta * p_r}};
}

TEST_CASE("far kerr: a view direction off by 1e-12 r_s of impact parameter is found" * test::costly()) {
    constexpr double kPlanted = 1e-12;
    Random random(seed());
    for (const double r : kRadii)
        for (int i = 0, escaped = 0; escaped < 4; ++i) {
            const KerrStart start = far_ray(0.7, r, 2 * i, random);                     // next to the edge
            if (reference::trace_kerr(0.7, start, 0).fate != Fate::kEscaped) continue;  // without a direction
            // Away from the edge, for along it answers hardly move; with the same L_z.
            if (!(std::abs(start.direction.y) > 0.7 * std::hypot(start.direction.y, start.direction.z))) continue;
            ++escaped;
            KerrStart moved = start;
            moved.direction.y += std::copysign(kPlanted / r, start.direction.y);
            Worst worst;
            judge(0.7, start, reference::trace_kerr(0.7, moved, 2), worst);
            CAPTURE(r);
            CHECK((worst.wrong > 0 || worst.b > kSureOf));
        }
}

TEST_CASE("far kerr: a photon by its ingoing components is the one by its direction") {
    Random random(seed());
    for (const double spin : kSpins)
        for (const double r : kRadii) {
            Worst worst;
            for (int i = 0; i < 4; ++i) {
                const KerrStart start = far_ray(spin, r, i, random);
                KerrRay ray = reference::trace_kerr(spin, photon_of(spin, start), 2);
                judge(spin, start, ray, worst);
            }
            CHECK(worst.wrong + worst.lost == 0);
            CHECK(worst.b < kSureOf);
            CHECK(worst.place < 1);
            CHECK(worst.time < 1);
        }
}

TEST_CASE("far kerr: the series in 50 digits and in long double are one") {
    Random random(seed());
    for (const double spin : kSpins)
        for (const double r : {kRadii.front(), kRadii.back()}) {
            const KerrStart start = far_ray(spin, r, 3, random);
            const Kerr kerr(taylor_start<long double>(spin, start));
            const TaylorKerr<Real50> exact(taylor_start<Real50>(spin, start));
            REQUIRE(kerr.captured() == exact.captured());
            CHECK(std::abs(static_cast<double>(kerr.mu() - exact.mu())) < kSameSeries);
            CHECK(std::abs(static_cast<double>(kerr.phi() - exact.phi())) < kSameSeries);
            CHECK(std::abs(static_cast<double>(kerr.delay() - exact.delay())) < 1e-17 * r + 1e-10);
        }
}
