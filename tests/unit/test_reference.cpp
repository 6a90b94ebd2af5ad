// The reference against literature values, identities and itself. (Rows of vectors: test_reference_vectors.cpp.)
#include <cmath>

#include <doctest/doctest.h>

#include "reference/reference.h"

namespace {

using namespace nullscope;
using reference::trace_ray;

// A few dozen roundings of numbers of order one.
constexpr double kReferenceRounding = 1e-14;
// Literature values are printed with 12 to 17 digits: half a unit of the shortest, relative.
constexpr double kReferencePrinted = 2e-11;
constexpr double kPrintedFully = 2e-14;

RayQuery reduced(double q, double zeta0, int s) {
    RayQuery query;
    query.orbit = ReducedRay{q, zeta0, s};
    return query;
}

RayQuery local(double r, double theta, double phi, Vec3 n, LocalFrame frame = LocalFrame::kStatic) {
    RayQuery query;
    query.r = r;
    query.theta = theta;
    query.phi = phi;
    query.n = n;
    query.frame = frame;
    return query;
}

RayRecord record_of(const RayQuery& query, int crossings = 0, const Scene& scene = {}) {
    const auto record = trace_ray(scene, query, crossings);
    REQUIRE_MESSAGE(record, (record ? "" : record.error().message()));
    return *record;
}

// Deflection of a ray from infinity to infinity: the two ways from one point of it add up to the whole.
double deflection(double b_over_m) {
    const double q = 2 / b_over_m, zeta0 = 0.01 * q;
    return record_of(reduced(q, zeta0, 1)).angle + record_of(reduced(q, zeta0, -1)).angle - M_PI;
}
double deflection_from_periapsis(double r_over_m) {
    return 2 * record_of(local(r_over_m / 2, M_PI / 2, 0, {0, 0, 1})).angle - M_PI;
}

TEST_CASE("reference: deflection angles of the literature") {
    const double by_impact[][2] = {{5.2, 6.8103719566634969},   {5.5, 2.5530201823453383},
                                   {6, 1.7193883102301686},     {10, 0.59039578760582732},
                                   {100, 0.041222539749273652}, {1000, 0.0040118238099253647}};
    // The inputs' rounding is amplified by b |dalpha/db| <= b/(b - b_crit), 1350 for b = 5.2.
    constexpr double kImpactCondition = 1350;
    for (const auto& [b, alpha] : by_impact) CHECK(std::abs(deflection(b) - alpha) < kPrintedFully * kImpactCondition);
    const double by_periapsis[][2] = {{3.000001, 29.022551434291382},
                                      {3.01, 10.610788280962593},
                                      {3.21, 4.6996361490166478},
                                      {4, 2.1841001877275592},
                                      {10, 0.5002356566077917}};
    for (const auto& [r, alpha] : by_periapsis) {
        const double condition = 2 * r / (r - 3);  // alpha ~ -2 ln(r/3 - 1)
        CHECK(std::abs(deflection_from_periapsis(r) - alpha) < kPrintedFully * condition);
    }
    // Turned back exactly; printed with 15 digits, amplified by 34 and 12.
    CHECK(std::abs(deflection(5.35695863074179) - M_PI) < 34 * kPrintedFully);
    CHECK(std::abs(deflection_from_periapsis(3.52061796315193) - M_PI) < 12 * kPrintedFully);
}

TEST_CASE("reference: weak deflection is 4/b + 15 pi/(4 b^2) + 128/(3 b^3)") {
    // Next term 3465 pi/(64 b^4) = 1.7e-10 at b = 1000, 1.7e-14 at 1e4; the swept angle pi is rounded to 4e-16.
    for (const double b : {1e3, 1e4, 1e6}) {
        const double series = 4 / b + 15 * M_PI / (4 * b * b) + 128 / (3 * b * b * b);
        CHECK(std::abs(deflection(b) - series) < 1.1 * 3465 * M_PI / 64 / std::pow(b, 4) + 2e-15);
    }
}

// Angle from the inward direction at which rays begin to reach the sky, degrees.
double shadow_edge(double r, LocalFrame frame) {
    double in = 0, out = M_PI;
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.5 * (in + out);
        const bool escapes =
            record_of(local(r, 1.2, 0.3, {-std::cos(angle), 0, std::sin(angle)}, frame)).fate == Fate::kEscaped;
        (escapes ? out : in) = angle;
    }
    return 0.5 * (in + out) * 180 / M_PI;
}

TEST_CASE("reference: the shadow's edge for static and falling observers") {
    const double statics[][2] = {{100, 2.94855519768}, {10, 27.6945614508}, {6, 45}, {3, 90}, {2.2, 134.591038022}};
    for (const auto& [r, degrees] : statics) {
        CHECK(shadow_edge(r / 2, LocalFrame::kStatic) == doctest::Approx(degrees).epsilon(kReferencePrinted));
    }
    for (const double rho : {50.0, 5.0, 3.0, 1.6, 1.1, 1.001}) {  // Synge: sin^2 = 27/4 (rho-1)/rho^3, obtuse inside 3M
        const double sine = std::sqrt(6.75 * (rho - 1) / (rho * rho * rho)), acute = std::asin(sine) * 180 / M_PI;
        // The edge comes from a sine: its rounding is amplified by tan(angle).
        const double expected = rho < 1.5 ? 180 - acute : acute;
        CHECK(std::abs(shadow_edge(rho, LocalFrame::kStatic) - expected) <
              180 / M_PI * kReferenceRounding * (1 + std::tan(std::asin(sine))));
    }
    const double rains[][2] = {
        {10, 17.3241986566}, {3, 35.2643896828}, {2, 42.1034488707}, {1, 53.2702658035}, {.1, 77.3257155812}};
    for (const auto& [r, degrees] : rains) {
        CHECK(shadow_edge(r / 2, LocalFrame::kRain) == doctest::Approx(degrees).epsilon(kReferencePrinted));
    }
}

TEST_CASE("reference: light time through the periapsis, from 1000M to 1000M") {
    // In to infinity minus out to infinity leaves twice the way to the periapsis. Units: r_s = 2M.
    const double times[][2] = {{6, 2034.71014050567}, {10, 2026.465430162}, {100, 2004.192088803}};
    for (const auto& [b, time] : times) {
        const double q = 2 / b, zeta0 = 2e-3;
        const double lag = record_of(reduced(q, zeta0, 1)).delay - record_of(reduced(q, zeta0, -1)).delay;
        CHECK(2 * lag == doctest::Approx(time).epsilon(1e-12));  // printed with 13 digits
    }
    CHECK(record_of(local(7, 1, 1, {1, 0, 0})).delay == 0);  // straight out: no lag behind v
}

TEST_CASE("reference: the general form agrees with the reduced form") {
    for (const double r : {1.0000001, 1.3, 1.5, 1.6, 4.0, 1e3, 1e8}) {
        for (const double alpha : {1e-6, 0.2, 1.4, 2.0, 3.1}) {  // from the outward direction
            const double q = std::sqrt((r - 1) / r) / r / std::sin(alpha);
            const RayRecord general = record_of(local(r, M_PI / 2, 0.5, {std::cos(alpha), 0, std::sin(alpha)}));
            const auto other = trace_ray(Scene{}, reduced(q, 1 / r, std::cos(alpha) > 0 ? -1 : 1));
            REQUIRE(other);
            CAPTURE(r);
            CAPTURE(alpha);
            // q and zeta0 are rounded here; the angle reacts with 1/|q/q_crit - 1|, the lapse with 1/(r - 1).
            const double condition = 1 / std::abs(q / 0.3849001794597505 - 1) + r / (r - 1) + 1;
            CHECK(general.fate == other->fate);
            CHECK(general.angle == doctest::Approx(other->angle).epsilon(kReferenceRounding * condition));
            CHECK(general.g == doctest::Approx(other->g).epsilon(kReferenceRounding * condition));
            if (general.fate != Fate::kEscaped) continue;
            CHECK(general.delay == doctest::Approx(other->delay).epsilon(kReferenceRounding * condition));
            CHECK(general.phi_inf - 0.5 == doctest::Approx(other->phi_inf).epsilon(kReferenceRounding * condition));
            CHECK(std::abs(general.theta_inf - M_PI / 2) < kReferenceRounding);
        }
    }
}

TEST_CASE("reference: the static and the rain frame see the same rays") {
    for (const double r : {1.01, 1.5, 3.0, 40.0}) {
        for (const double alpha : {0.3, 1.2, 2.5, 3.0}) {
            const double w = std::sqrt(1 / r), c = std::cos(alpha), lapse = std::sqrt(1 - 1 / r);
            // The raindrop moves inward with w past the static observer.
            const Vec3 rain{(c - w) / (1 - w * c), 0, lapse * std::sin(alpha) / (1 - w * c)};
            const RayRecord at_rest = record_of(local(r, 1, 2, {c, 0, std::sin(alpha)}));
            const RayRecord falling = record_of(local(r, 1, 2, rain, LocalFrame::kRain));
            const double condition = 100 / (r - 1) + 100;
            CHECK(at_rest.fate == falling.fate);
            CHECK(at_rest.angle == doctest::Approx(falling.angle).epsilon(kReferenceRounding * condition));
            CHECK(falling.g * (1 + w * rain.x) ==
                  doctest::Approx(1).epsilon(kReferenceRounding * falling.g));  // the sum cancels by g
        }
    }
}

TEST_CASE("reference: the null norm is conserved along the ray") {
    // (dzeta/dphi)^2 + zeta^2 - zeta^3 = q^2. Derivative by five-point differences: error h^4 f'''''/30 + rounding/h.
    constexpr double kStep = 1e-3, kNorm = 1e-10;
    struct Case {
        double q, zeta0;
        int s;
    };
    for (const Case& c : {Case{0.2, 0.01, 1}, Case{0.3849, 0.1, 1}, Case{0.38491, 1e-3, 1}, Case{0.5, 0.9, -1},
                          Case{0.38, 0.9, -1}, Case{1.5, 0.2, 1}, Case{0.45, 1.2, -1}, Case{0.1, 0.05, -1}}) {
        RayQuery query = reduced(c.q, c.zeta0, c.s);
        const double end = record_of(query).angle;
        const auto zeta = [&](double angle) {
            query.at_angle = angle;
            return record_of(query).at;
        };
        for (int i = 1; i < 12; ++i) {
            const double a = end * i / 12, z = zeta(a);
            const double slope =
                (8 * (zeta(a + kStep) - zeta(a - kStep)) - (zeta(a + 2 * kStep) - zeta(a - 2 * kStep))) / (12 * kStep);
            CHECK(std::abs(slope * slope + z * z * (1 - z) - c.q * c.q) < kNorm);
        }
    }
}

TEST_CASE("reference: radial rays, rays along the axis and in the equatorial plane") {
    for (const double theta : {0.0, 1.0, M_PI / 2, M_PI}) {
        const RayRecord out = record_of(local(3, theta, 0.7, {1, 0, 0}), 3),
                        in = record_of(local(3, theta, 0.7, {-1, 0, 0}), 3);
        CHECK(out.fate == Fate::kEscaped);
        CHECK(out.angle == 0);
        CHECK(std::abs(out.theta_inf - theta) < kReferenceRounding);
        CHECK(out.phi_inf == 0.7);
        CHECK(out.crossings.empty());
        CHECK(in.fate == Fate::kCaptured);
        CHECK(in.angle == 0);
    }
    // On the axis, looking along the meridian of azimuth phi + pi/2 (e_phi there).
    const RayRecord axis = record_of(local(5, 0, 0.2, {0, 0, 1}), 2);
    CHECK(axis.phi_inf == doctest::Approx(0.2 + M_PI / 2).epsilon(kReferenceRounding));
    CHECK(axis.theta_inf == doctest::Approx(axis.angle).epsilon(kReferenceRounding));
    CHECK(axis.crossings.size() == 1);
    // Over the pole: theta grows from the other side, phi jumps by pi.
    const RayRecord over = record_of(local(50, 0.4, 1.0, {0, -1, 0}));
    CHECK(over.phi_inf == doctest::Approx(1.0 + M_PI).epsilon(kReferenceRounding));
    CHECK(over.theta_inf == doctest::Approx(over.angle - 0.4).epsilon(kReferenceRounding));
    // In the plane: no crossings, phi unwrapped over windings. phi_inf falls for n_phi < 0.
    const double alpha = std::asin(std::sqrt(6.75 * 4 / 125.0) * (1 + 1e-9));
    const RayRecord wound = record_of(local(5, M_PI / 2, 3, {-std::cos(alpha), 0, -std::sin(alpha)}), 4);
    CHECK(wound.fate == Fate::kEscaped);
    CHECK(wound.angle > 6 * M_PI);
    CHECK(wound.phi_inf == doctest::Approx(3 - wound.angle).epsilon(kReferenceRounding));
    CHECK(wound.crossings.empty());
    // From the equator, tilted: the first crossing is half a turn away.
    const RayRecord tilted =
        record_of(local(5, M_PI / 2, 3, {-std::cos(alpha), std::sin(alpha) * 0.6, std::sin(alpha) * 0.8}), 9);
    REQUIRE(static_cast<double>(tilted.crossings.size()) == std::floor(wound.angle / M_PI));
    CHECK(tilted.crossings[0].phi == doctest::Approx(3 + M_PI).epsilon(kReferenceRounding));
    CHECK(tilted.crossings[3].phi == doctest::Approx(3 + 4 * M_PI).epsilon(kReferenceRounding));
}

TEST_CASE("reference: crossings lie where at_angle says, and phi is continuous over windings") {
    const double alpha = std::asin(std::sqrt(6.75 * 4 / 125.0) * (1 + 1e-6));
    RayQuery query = local(5, 1.1, -2, {-std::cos(alpha), 0.6 * std::sin(alpha), -0.8 * std::sin(alpha)});
    const RayRecord record = record_of(query, 20);
    REQUIRE(record.crossings.size() >= 5);
    const double first = std::atan2(std::cos(1.1), 0.6 * std::sin(1.1));
    for (std::size_t k = 0; k < record.crossings.size(); ++k) {
        query.at_angle = first + static_cast<double>(k) * M_PI;
        CHECK(record.crossings[k].r == doctest::Approx(1 / record_of(query).at).epsilon(kReferenceRounding));
        if (k > 0)
            CHECK(record.crossings[k].phi ==
                  doctest::Approx(record.crossings[k - 1].phi - M_PI).epsilon(kReferenceRounding));
    }
    CHECK(record.phi_inf < record.crossings.back().phi);
    CHECK(record.phi_inf > record.crossings.back().phi - M_PI);
}

TEST_CASE("reference: cameras on the photon sphere and at turning points") {
    const RayRecord circle = record_of(local(1.5, 1, 0, {0, 0, 1}));
    CHECK(circle.fate == Fate::kNoSky);
    CHECK(std::isnan(circle.angle));
    for (const double n_r : {1e-3, 1e-9, 1e-15, 1e-100}) {  // the smallest tilt decides
        CHECK(record_of(local(1.5, 1, 0, {n_r, 0, 1})).fate == Fate::kEscaped);
        CHECK(record_of(local(1.5, 1, 0, {-n_r, 0, 1})).fate == Fate::kCaptured);
        CHECK(std::isfinite(record_of(local(1.5, 1, 0, {n_r, 0, 1})).angle));
    }
    const RayRecord touch = record_of(local(4, 1, 0, {0, 0, 1}));
    CHECK(touch.fate == Fate::kEscaped);
    CHECK(touch.turn == doctest::Approx(0.25).epsilon(kReferenceRounding));
    CHECK(record_of(local(1.2, 1, 0, {0, 1, 0})).fate == Fate::kCaptured);
}

TEST_CASE("reference: flat space is straight") {
    Scene scene;
    scene.spacetime.metric = "minkowski";
    const RayRecord past = record_of(local(8, 1.2, 0.4, {-0.6, 0, 0.8}), 2, scene);
    CHECK(past.fate == Fate::kEscaped);
    CHECK(past.angle == doctest::Approx(std::atan2(0.8, -0.6)).epsilon(kReferenceRounding));
    CHECK(past.turn == doctest::Approx(1 / (8 * 0.8)).epsilon(kReferenceRounding));
    CHECK(past.delay == doctest::Approx(8 * 1.6).epsilon(kReferenceRounding));
    CHECK(past.g == 1);
    RayQuery query = reduced(0.2, 0.125, 1);
    query.at_angle = 1.0;
    CHECK(record_of(query, 0, scene).at ==
          doctest::Approx(0.2 * std::sin(std::asin(0.125 / 0.2) + 1)).epsilon(kReferenceRounding));
    CHECK(record_of(reduced(INFINITY, 0.125, 1), 0, scene).angle == doctest::Approx(M_PI).epsilon(kReferenceRounding));
    CHECK(!trace_ray(scene, reduced(0.1, 0.125, 1)));
}

TEST_CASE("reference: questions outside the domain are answered with a reason") {
    const auto refused = [](const RayQuery& query, const Scene& scene = {}) {
        const auto record = trace_ray(scene, query, 1);
        return !record && record.error().kind == ErrorKind::kBadInput && !record.error().message().empty();
    };
    CHECK(refused(local(1, 1, 0, {1, 0, 0})));
    CHECK(refused(local(0.5, 1, 0, {1, 0, 0})));
    CHECK(refused(local(-2, 1, 0, {1, 0, 0}, LocalFrame::kRain)));
    CHECK(refused(local(kNotANumber, 1, 0, {1, 0, 0})));
    CHECK(refused(local(3, 4, 0, {1, 0, 0})));
    CHECK(refused(local(3, 1, kNotANumber, {1, 0, 0})));
    CHECK(refused(local(3, 1, 0, {0, 0, 0})));
    CHECK(refused(local(3, 1, 0, {kNotANumber, 0, 0})));
    CHECK(refused(reduced(0, 0.1, 1)));
    CHECK(refused(reduced(0.3, 0.5, 1)));  // below the hill: q^2 < V
    CHECK(refused(reduced(kNotANumber, 0.1, 1)));
    CHECK(refused(reduced(0.3, 0, 1)));
    CHECK(refused(reduced(0.3, 0.1, 0)));
    Scene other;
    other.spacetime.metric = "no such metric";
    CHECK(refused(local(3, 1, 0, {1, 0, 0}), other));
    RayQuery late = reduced(0.3, 0.1, 1);
    late.at_angle = -1.0;
    CHECK(refused(late));
    // Inside the horizon looking in with the rain: an answer, without a sky.
    const RayRecord dark = record_of(local(0.5, 1, 0, {-1, 0, 0}, LocalFrame::kRain));
    CHECK(dark.fate == Fate::kNoSky);
    CHECK(std::isnan(dark.angle));
}

}  // namespace
