// How the light of bodies with a temperature is shifted: the reference against closed forms of what rests, circles, falls and pulsates.
#include <cmath>
#include <optional>
#include <tuple>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "reference/body_shift.h"
#include "reference/frame_tracer.h"
#include "support/draft.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Of the first body that a place of the picture shows: camera frequency over that of the body.
std::optional<double> g_at(const Scene& scene, double x, double y) {
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const auto ray = tracer->ray(x, y);
    const auto hit = ray->first_hit();
    if (!hit) return {};
    const auto own = reference::body_shift(tracer->matter(), *ray, *hit, scene.light.lensing);
    return reference::Shift{ray->shift.gravity * own.gravity, ray->shift.doppler * own.doppler}.seen(scene.light);
}

Scene hot(Scene scene) {
    for (Body& body : scene.bodies) body.material.temperature_K = 6000;
    return scene;
}

Draft hole(const char* metric, double spin) {
    Draft draft;
    draft.metric(metric).place(12, 1.1).size(32, 18).plane(1.2).sky(SkyKind::kBlack);
    if (spin != 0) draft.spin(spin).by(ObserverKind::kZamo);
    return draft;
}

TEST_CASE("body shift: what rests has sqrt(-g_tt), whatever light does") {
    constexpr double kDigits = 1e-12;
    const auto g = g_at(hot(hole("schwarzschild", 0).sphere(3)), 16.01, 9.02);
    REQUIRE(g);
    CHECK(*g == doctest::Approx(std::sqrt((1 - 1 / 3.0) / (1 - 1 / 12.0))).epsilon(kDigits));
    const Scene scene = hot(hole("kerr", 0.9).sphere(1.2));
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const auto ray = tracer->ray(16.5, 9.5);
    const auto hit = ray->first_hit();
    REQUIRE(hit);
    const double a = 0.45, cosine = hit->place.z / 1.2, rest = 1 - 1.2 / (1.2 * 1.2 + a * a * cosine * cosine);
    CHECK(*g_at(scene, 16.5, 9.5) == doctest::Approx(ray->g * std::sqrt(rest)).epsilon(kDigits));
    // On the equator the ergosphere reaches to 1 r_s: a sphere within it is dark there.
    CHECK(*g_at(hot(hole("kerr", 0.9).sphere(0.9)), 16.5, 9.5) == 0);
}

// A sphere that turns: g = g_camera sqrt(-g_tt - 2 Omega g_tphi - Omega^2 g_phiphi)/(1 - Omega L), of Kerr's metric anywhere on it.
TEST_CASE("body shift: what turns has that of its surface") {
    constexpr double kDigits = 1e-9;  // in a plane the photon's direction is a difference over 1e-6 rad
    double worst = 0;
    for (const double spin : {0.0, 0.9})
        for (const double rate : {0.2, -0.1}) {
            CAPTURE(spin);
            CAPTURE(rate);
            Scene scene = hot(hole(spin == 0 ? "schwarzschild" : "kerr", spin).sphere(2));
            std::get<SphereSpec>(scene.bodies.front().shape).spin_rate = rate;
            const auto tracer = reference::FrameTracer::make(scene);
            REQUIRE(tracer);
            for (const double x : {14.6, 16.5, 17.2}) {
                const auto ray = tracer->ray(x, 8.7);
                const auto hit = ray->first_hit();
                REQUIRE(hit);
                const double a = 0.5 * spin, r = 2, cosine = hit->place.z / r, sine2 = 1 - cosine * cosine,
                             sigma = r * r + a * a * cosine * cosine, pull = r / sigma;
                const double norm = 1 - pull + 2 * rate * a * pull * sine2 -
                                    rate * rate * sine2 * (r * r + a * a + a * a * pull * sine2);
                const double closed = ray->shift.gravity * ray->shift.doppler * std::sqrt(norm) / (1 - rate * ray->l_z);
                worst = std::max(worst, std::fabs(*g_at(scene, x, 8.7) / closed - 1));
                CHECK(hit->turn == doctest::Approx(rate * (scene.time - ray->delay(hit->along))).epsilon(1e-9));
            }
        }
    fmt::print("body shift: of what turns off by {:.1e} at most\n", worst);
    CHECK(worst < kDigits);
}

// A ball so small that it is a point, where a ray crosses the plane of its circle: g = g_camera sqrt(-g_tt - 2 Omega g_tphi - Omega^2 g_phiphi)/(1 -
// Omega L), Omega = 1/(sqrt(2 r^3) + a).
TEST_CASE("body shift: what circles has that of its orbit") {
    constexpr double kPoint = 1e-3, kAlike = 1e-3;
    for (const double spin : {0.0, 0.9, -0.7}) {
        Draft draft = hole(spin == 0 ? "schwarzschild" : "kerr", spin);
        draft.scene.light.delay = false;
        draft.disc(2, 12);
        const auto plain = reference::FrameTracer::make(draft);
        REQUIRE(plain);
        int seen = 0;
        double least = 1e9, most = 0;
        for (double x = 4.5; x < 32; x += 6) {
            const auto ray = plain->ray(x, 12.5);
            const auto hits = plain->disc_hits(*ray, 1);
            if (hits.empty()) continue;
            const double r = std::hypot(hits[0].x, hits[0].y), a = 0.5 * spin;
            const double omega = 1 / (std::sqrt(2 * r * r * r) + a);
            const double norm = 1 - 1 / r + 2 * omega * a / r - omega * omega * (r * r + a * a + a * a / r);
            const double closed = ray->shift.gravity * ray->shift.doppler * std::sqrt(norm) / (1 - omega * ray->l_z);
            Scene scene = draft;
            scene.disc.reset();
            Body ball{BallSpec{.position = {hits[0].x, hits[0].y, 0}, .radius = kPoint, .motion = BallMotion::kOrbit}};
            scene.bodies = {ball};
            const auto g = g_at(hot(scene), x, 12.5);
            CAPTURE(spin);
            CAPTURE(x);
            CAPTURE(r);
            REQUIRE(g);
            CHECK(*g == doctest::Approx(closed).epsilon(kAlike));
            ++seen, least = std::min(least, *g), most = std::max(most, *g);
        }
        fmt::print("body shift: about a = {} of {} places g is {:.4f} to {:.4f}\n", spin, seen, least, most);
        CHECK(seen >= 3);
        CHECK(most > 1.2 * least);
    }
}

// The same along the axis of a rotating hole, where A = Delta/(r^2 + a^2) = 1/B: the slope tends to -kappa, the surface gravity of the
// horizon, kappa = (r_+ - r_-)/(2 (r_+^2 + a^2)); without rotation and charge 1/2.
TEST_CASE("body shift: a lamp that falls along the axis of a rotating hole reddens as exp(-kappa t)") {
    constexpr double kSlope = 1e-3;
    constexpr double kVelocity = 1e-7;  // of what is a difference: 1 - w^2 is some A
    constexpr double kStart = 6;
    for (const auto& [spin, charge, last] : {std::tuple{0.9, 0.0, 40.0}, {-0.6, 0.6, 37.5}}) {
        const double a = 0.5 * spin, root = std::sqrt(1 - spin * spin - charge * charge), outer = 0.5 * (1 + root),
                     inner = 0.5 * (1 - root);
        const auto area = [&](double r) { return r * r + a * a; };
        const auto lapse2 = [&](double r) { return (r - outer) * (r - inner) / area(r); };
        const auto tortoise = [&](double r) {
            return r + (area(outer) * std::log(r - outer) - area(inner) * std::log(r - inner)) / root;
        };
        const double energy = std::sqrt(lapse2(kStart)), kappa = 0.5 * root / area(outer);
        Draft draft;
        draft.metric("kerr-newman", {{"spin", spin}, {"charge", charge}}).place(20, 0).by(ObserverKind::kZamo);
        draft.size(1, 1).plane(0.01).sky(SkyKind::kBlack);
        draft.body(BallSpec{.position = {0, 0, kStart}, .radius = 0.01, .motion = BallMotion::kGeodesic});
        const Scene scene = hot(draft);
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE(tracer);
        const reference::Bodies bodies(scene, tracer->matter());
        const reference::BodyPart& part = bodies.parts().front();
        const auto ray = tracer->ray(0.5, 0.5);
        double slope = 0;
        for (const double t : {10.0, 22.0, 32.0, last}) {
            double clocks[2], gs[2];
            for (const int i : {0, 1}) {
                const double when = t + (i == 0 ? -0.1 : 0.1);
                reference::BodyHit hit{0, part.middle(when), part.number, 0, {0, 0, 1}, 1, part.middle(when)};
                hit.toward = {0, 0, 1};
                part.tell(hit, when);
                const double r = hit.middle.z, here = lapse2(r);
                const auto own = reference::body_shift(tracer->matter(), *ray, hit, true);
                gs[i] = own.gravity * own.doppler, clocks[i] = when - tortoise(r);
                CAPTURE(a);
                CAPTURE(r);
                CHECK(std::fabs(gs[i] * (energy + std::sqrt(energy * energy - here)) / here - 1) < kVelocity / here);
            }
            slope = std::log(gs[1] / gs[0]) / (clocks[1] - clocks[0]);
            fmt::print("body shift: a/M = {}, Q/M = {}: r - r_+ = {:.1e}: slope of ln(g) {:.6f}, -kappa {:.6f}\n", spin,
                       charge, part.middle(t).z - outer, slope, -kappa);
        }
        CHECK(std::fabs(slope + kappa) < kSlope);
    }
}

// From rest at r_0 = 6, seen from above: u^t = E/A, u^r = -sqrt(E^2 - A), so light to the camera has g = A/(E + sqrt(E^2 - A)) of what the one at
// infinity has, and the camera's clock runs by dt - dr_*: the slope of ln(g) is -1/(2 r^2), over r_s/c, where E = 1, and tends to -1/2.
TEST_CASE("body shift: a lamp that falls reddens as exp(-t/2)") {
    constexpr double kSlope = 1e-3, kHit = 2e-3;
    constexpr double kG = 1e-4;  // next to the horizon: the velocity is a difference, and 1 - w^2 falls with A
    const double energy = std::sqrt(1 - 1 / 6.0), camera = std::sqrt(1 - 1 / 20.0);
    const BallSpec lamp{.position = {6, 0, 0}, .radius = 0.01, .motion = BallMotion::kGeodesic};
    Draft draft;
    draft.metric("schwarzschild").place(20, M_PI / 2).size(1, 1).plane(0.01).sky(SkyKind::kBlack).body(lamp);
    const Scene scene = hot(draft);
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const reference::Bodies bodies(scene, tracer->matter());
    const reference::BodyPart& part = bodies.parts().front();
    const auto ray = tracer->ray(0.501, 0.5);
    const auto tortoise = [](double r) { return r + std::log(r - 1); };
    struct Seen {
        double clock, g;
    };
    const auto seen = [&](double t) {
        reference::BodyHit hit{0, part.middle(t), part.number, 0, {1, 0, 0}, 1, part.middle(t)};
        hit.toward = {1, 0, 0};
        part.tell(hit, t);
        const double r = hit.middle.x, lapse2 = 1 - 1 / r;
        const auto own = reference::body_shift(tracer->matter(), *ray, hit, true);
        const double g = own.gravity * own.doppler;
        CAPTURE(r);
        CHECK(std::fabs(g * (energy + std::sqrt(energy * energy - lapse2)) / lapse2 - 1) < kG);
        return Seen{t - tortoise(r), g};
    };
    double slope = 0;
    for (const double t : {10.0, 20.0, 28.0, 34.0}) {
        const Seen before = seen(t - 0.1), after = seen(t + 0.1);
        slope = std::log(after.g / before.g) / (after.clock - before.clock);
        fmt::print("body shift: r = {:.5f}: g = {:.3e}, slope of ln(g) {:.5f}\n", part.middle(t).x, after.g, slope);
    }
    CHECK(std::fabs(slope + 0.5) < kSlope);
    // And as the picture shows it: where the light of t = 10 arrives.
    Scene later = scene;
    later.time = 10 + tortoise(20) - tortoise(part.middle(10).x);
    const auto g = g_at(later, 0.501, 0.5);
    REQUIRE(g);
    CHECK(*g == doctest::Approx(seen(10).g / camera).epsilon(kHit));
}

TEST_CASE("body shift: a pulsating sphere's surface comes and goes") {
    Scene scene = hole("minkowski", 0);
    scene.light.delay = false;
    scene.bodies = {Body{SphereSpec{.radius = 3, .amplitude = 0.2, .period = 20}}};
    for (const double time : {0.0, 5.0, 10.0}) {  // fastest outward, still, fastest inward
        scene.time = time;
        const double speed = 3 * 0.2 * 2 * M_PI / 20 * std::cos(2 * M_PI * time / 20);
        const auto g = g_at(hot(scene), 16.01, 9.02);
        REQUIRE(g);
        CHECK(*g == doctest::Approx(std::sqrt((1 + speed) / (1 - speed))).epsilon(1e-5));
        scene.light.doppler = false;
        CHECK(*g_at(hot(scene), 16.01, 9.02) == doctest::Approx(1.0));
        scene.light.doppler = true;
    }
}

}  // namespace
