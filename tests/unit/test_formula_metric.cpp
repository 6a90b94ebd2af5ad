// Metrics given by formulas: against metrics with closed forms, against closed forms, and the table against the reference.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <memory>

#include "reference/orbit.h"
#include "scenefile/scene_file.h"
#include "spacetime/circular_orbit.h"
#include "support/depth.h"
#include "support/metrics.h"
#include "table/orbit_table.h"
#include "table/ray_family.h"
#include "table/throat_orbit.h"

namespace {

using namespace nullscope;

const std::string kKottler = "1 - 1/r - 0.0002*r^2/3", kStrongKottler = "1 - 1/r - 0.05*r^2/3",
                  kHayward = "1 - r^2/(r^3 + 0.35^2)", kBardeen = "1 - r^2/(r^2 + 0.35^2)^(3/2)";

MetricParameters formulas(const std::string& a, const std::string& b = "", const std::string& areal = "") {
    MetricParameters parameters;
    parameters.formulas["A"] = a;
    if (!b.empty()) parameters.formulas["B"] = b;
    if (!areal.empty()) parameters.formulas["R"] = areal;
    return parameters;
}

struct World {
    std::shared_ptr<const SphericalMetric> spacetime;
    std::shared_ptr<const DeflectionTable> table;
    std::shared_ptr<reference::Metric> reference;
};
World formula_world(const std::string& metric, const MetricParameters& parameters = {}) {
    World world;
    const auto made = make_spacetime(metric, parameters);
    REQUIRE_MESSAGE(made, made.error().message());
    world.spacetime = test::spherical(*made);
    world.table = std::make_shared<const DeflectionTable>(*world.spacetime);
    auto orbits = reference::make_metric({metric, parameters});
    REQUIRE(orbits);
    world.reference = std::move(*orbits);
    return world;
}
RayFamily fan_at_rest(const World& world, double r) {
    return {world.spacetime, world.table, r, frame_at_rest(world.spacetime->lapse_squared(r))};
}

// What is seen at the angle beta from the centre: whether it is sky, and the angle swept until the end. Camera outside of the photon sphere.
struct Seen {
    bool sky;
    double swept;
};
Seen seen_at(const RayFamily& family, double beta) {
    const double off = beta - family.critical_angle();
    const Segment segment = off > 0 ? Segment::kSky : Segment::kCaptured;
    return {off > 0, family.ray(segment, std::fabs(off)).phi_end};
}

// Every step-th pixel of a quarter of a 4K frame of 60 degrees; by symmetry the other three are the same.
template <class Visit>
long each_angle_of_4k(int step, const Visit& visit) {
    constexpr int kWidth = 3840, kHeight = 2160;
    const double pixel = 2 * std::tan(M_PI / 6) / kWidth;
    long count = 0;
    for (long i = 0; i < long(kWidth / 2) * (kHeight / 2); i += step, ++count)
        visit(std::atan(pixel * std::hypot(0.5 + double(i % (kWidth / 2)), 0.5 + double(i / (kWidth / 2)))));
    return count;
}

constexpr double kSameAngle = 1e-9;  // rad: a pixel of a 4K frame is 2.7e-4

TEST_CASE("formula: Schwarzschild's table from a formula is the built-in one at every pixel of a 4K frame") {
    const World formula = formula_world("formula", formulas("1 - 1/r", "1/(1 - 1/r)", "r")),
                hole = formula_world("schwarzschild");
    const RayFamily a = fan_at_rest(formula, 15), b = fan_at_rest(hole, 15);
    double worst = 0;
    const long count = each_angle_of_4k(test::by_depth(7, 1, 1), [&](double beta) {
        const Seen one = seen_at(a, beta), other = seen_at(b, beta);
        const double off = one.sky == other.sky ? std::fabs(one.swept - other.swept) : 1e9;
        if (!(off <= worst)) worst = off;
    });
    fmt::print("formula, 4K, table: {} pixels, largest difference {:.2g} rad\n", count, worst);
    CHECK(worst < kSameAngle);
    // It can fail: a mass that is larger by 1e-9.
    const RayFamily heavier = fan_at_rest(formula_world("formula", formulas("1 - 1.000000001/r")), 15);
    double shown = 0;
    each_angle_of_4k(10007, [&](double beta) {
        shown = std::fmax(shown, std::fabs(seen_at(heavier, beta).swept - seen_at(b, beta).swept));
    });
    CHECK(shown > kSameAngle);
}

TEST_CASE("formula: Schwarzschild's reference from a formula is the built-in one on a 4K frame") {
    const World formula = formula_world("formula", formulas("1 - 1/r")), hole = formula_world("schwarzschild");
    for (const double r : {15.0, 1.3}) {  // within the photon sphere, too
        double worst = 0;
        const long count = each_angle_of_4k(test::by_depth(4001, 127, 31), [&](double beta) {
            const reference::LocalRay ray{r, r > 1.5 ? -std::cos(beta) : std::cos(beta), std::sin(beta)};
            const auto one = formula.reference->orbits()->from_static(ray),
                       other = hole.reference->orbits()->from_static(ray);
            const double off = one->fate() == other->fate() ? std::fabs(one->angle() - other->angle()) : 1e9;
            if (!(off <= worst)) worst = off;
            for (const double part : {0.1, 0.5, 0.9}) {
                const double place = one->zeta_at(part * one->angle()), there = other->zeta_at(part * other->angle());
                worst = std::fmax(worst, std::fabs(place - there));
            }
        });
        fmt::print("formula, 4K, reference, r = {}: {} pixels, largest difference {:.2g} rad\n", r, count, worst);
        CHECK(worst < kSameAngle);
    }
}

// Largest error of the swept angle against the reference; each over 1 + d phi/d ln(delta): what the direction's last digit is worth.
double worst_sweep(const World& world, const RayFamily& family, double r, bool rain,
                   std::initializer_list<Segment> segments = {Segment::kSky, Segment::kCaptured}) {
    double worst = 0.0;
    for (const Segment segment : segments)
        for (double delta = 1e-6; delta < 0.999 * family.delta_limit(segment);
             delta *= test::by_depth(1.7, 1.2, 1.05)) {
            const FanRay ray = family.ray(segment, delta);
            const reference::LocalRay local{r, -std::cos(ray.beta), ray.sin_beta};
            const auto& orbits = *world.reference->orbits();
            const auto orbit = rain ? orbits.from_rain(local).orbit : orbits.from_static(local);
            if (!(orbit->angle() >= 0)) continue;  // no end: light from nowhere
            if ((orbit->fate() == Fate::kEscaped) != (segment == Segment::kSky)) return 1e9;
            const double slope = family.ray(segment, 1.001 * delta).phi_end - ray.phi_end,
                         off = std::fabs(ray.phi_end - orbit->angle()) / (1.0 + 1e3 * std::fabs(slope));
            if (!(off <= worst)) worst = off;
        }
    return worst;
}

TEST_CASE("formula: swept angles of the table are the reference's") {
    constexpr double kSweep = 4e-9;  // rad; as of the other metrics (test_ray_family.cpp)
    struct FormulaCase {
        std::string name;
        MetricParameters parameters;
        std::vector<double> radii;
        bool falls;
    };
    // The last two: Schwarzschild's hole again, with r measured otherwise.
    for (const FormulaCase& c :
         {FormulaCase{"Kottler", formulas(kKottler), {1.05, 1.4, 1.5, 3.0, 30.0, 120.0}, true},
          FormulaCase{"Kottler, strong", formulas(kStrongKottler), {1.1, 1.5, 2.0, 5.0, 6.8}, false},
          FormulaCase{"Hayward", formulas(kHayward), {0.83, 1.2, 1.5, 20.0, 1e5}, true},
          FormulaCase{"Bardeen", formulas(kBardeen), {0.75, 1.2, 1.5, 20.0, 1e5}, true},
          FormulaCase{"moved", formulas("1 - 1/(r + 0.5)", "", "r + 0.5"), {0.6, 1.0, 3.0, 30.0}, false},
          FormulaCase{"bent",
                      formulas("1 - 1/(r + 0.1/r)", "(1 - 0.1/r^2)^2/(1 - 1/(r + 0.1/r))", "r + 0.1/r"),
                      {1.0, 1.5, 30.0},
                      false}}) {
        const World world = formula_world("formula", c.parameters);
        double worst = 0;
        for (const double r : c.radii) {
            const double error = worst_sweep(world, fan_at_rest(world, r), r, false);
            MESSAGE(c.name << ", at rest at r = " << r << ": " << error << " rad");
            worst = std::fmax(worst, error);
            if (!c.falls) continue;
            const RayFamily rain(world.spacetime, world.table, r,
                                 falling_frame(world.spacetime->lapse_squared(r), 1.0));
            worst = std::fmax(worst, worst_sweep(world, rain, r, true));
        }
        fmt::print("formula, {}: table and reference differ by {:.2g} rad at most\n", c.name, worst);
        CHECK(worst < kSweep);
    }
}

TEST_CASE("formula: the same hole with r measured otherwise bends light the same") {
    const World hole = formula_world("schwarzschild"),
                moved = formula_world("formula", formulas("1 - 1/(r + 0.5)", "", "r + 0.5"));
    CHECK(*moved.spacetime->horizon_radius() == doctest::Approx(0.5).epsilon(1e-14));
    const RayFamily a = fan_at_rest(hole, 15), b = fan_at_rest(moved, 14.5);
    double worst = 0;
    each_angle_of_4k(997, [&](double beta) {
        worst = std::fmax(worst, std::fabs(seen_at(a, beta).swept - seen_at(b, beta).swept));
    });
    CHECK(worst < 4e-9);  // two tables' errors
    CHECK_FALSE(moved.spacetime->can_have_disc());
}

// b_crit = 1/q_crit. Hayward's and Bardeen's: mpmath 1.3.0 with 40 digits, findroot on the derivative of zeta^2 A(1/zeta).
TEST_CASE("formula: photon spheres, critical impact parameters and horizons to 1e-12") {
    struct Known {
        std::string a;
        double photon, b_crit, horizon;
    };
    for (const Known& k :
         {Known{kHayward, 1.3654282854524419513830534908713, 2.4877295575698022990025826759366,
                0.81604787257469994928758509247542},
          Known{kBardeen, 1.2374767784003384297828232019556, 2.3385969256840743496418029482248,
                0.73717984938120339646875471205319},
          Known{kKottler, 1.5, std::sqrt(6.75 / (1 - 2.25 * 0.0002)), 1.0000666800035566423349402264575}}) {
        CAPTURE(k.a);
        const auto s = test::spherical(*make_spacetime("formula", formulas(k.a)));
        fmt::print("formula, {}: b_crit {:.16g}, off by {:.2g}; photon sphere off by {:.2g}\n", k.a,
                   1 / s->photon_sphere()->q_crit, 1 / s->photon_sphere()->q_crit - k.b_crit,
                   s->photon_sphere()->radius - k.photon);
        CHECK(std::fabs(1 / s->photon_sphere()->q_crit - k.b_crit) < 1e-12);
        CHECK(std::fabs(s->photon_sphere()->radius - k.photon) < 1e-12);
        CHECK(std::fabs(*s->horizon_radius() - k.horizon) < 1e-12);
    }
    const auto kottler = test::spherical(*make_spacetime("formula", formulas(kKottler)));
    CHECK(kottler->camera_range().high == doctest::Approx(121.97139149035062450673380259806).epsilon(1e-14));
    CHECK(kottler->v_at_sky() == -0.0002 / 3);
}

// Of a static observer: sin^2(alpha) = b_crit^2 A(r)/r^2 with 1/b_crit^2 = 4/27 - Lambda/3, whatever r (Stuchlik and Hledik 1999).
TEST_CASE("formula: Kottler's shadow between the two horizons is the closed form") {
    for (const auto& [text, lambda] : {std::pair{kKottler, 0.0002}, {kStrongKottler, 0.05}}) {
        const World world = formula_world("formula", formulas(text));
        const auto range = world.spacetime->camera_range();
        double worst = 0;
        for (int i = 1; i < 200; ++i) {
            const double r = range.low * std::pow(range.high / range.low, i / 200.0);
            const RayFamily family = fan_at_rest(world, r);
            const double a = 1 - 1 / r - lambda * r * r / 3, sine2 = a / (r * r) / (4 / 27.0 - lambda / 3);
            // cos^2 as a product next to the photon sphere: 1 - sin^2 = (1 - 3/(2 r))^2 (1 + 3/r) / (27/4 (4/27 - Lambda/3)).
            const double cosine2 = std::pow(1 - 1.5 / r, 2) * (1 + 3 / r) / (27 / 4.0 * (4 / 27.0 - lambda / 3));
            const double angle = std::atan2(std::sqrt(sine2), std::sqrt(cosine2)),
                         of_fan = std::acos(-family.critical_cosine());
            CHECK(sine2 + cosine2 == doctest::Approx(1).epsilon(1e-12));
            worst = std::fmax(worst, std::fabs((r > 1.5 ? angle : M_PI - angle) - of_fan));
        }
        fmt::print("formula, Kottler, Lambda = {}: shadow off by {:.2g} rad at most\n", lambda, worst);
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("formula: places along rays are the reference's, also where V does not vanish far out") {
    constexpr double kPlace = 2e-6;  // of zeta, in floats, over the ray's conditioning (orbit_table.h)
    const World world = formula_world("formula", formulas(kKottler));
    const RayFamily family = fan_at_rest(world, 30);
    const OrbitTable map = build_orbit_table(family, false);
    // The columns' own rays: the nodes of u at whole octaves.
    constexpr int kColumns = 13;
    double worst = 0;
    for (int octave = 12; octave < family.octaves(Segment::kSky) - 1; ++octave) {
        const double delta = family.delta_at(std::exp2(octave));
        const FanRay ray = family.ray(Segment::kSky, delta);
        const auto orbit = world.reference->orbits()->from_static({30, -std::cos(ray.beta), ray.sin_beta});
        for (int row = 1; row < family.orbit_rows(); ++row) {
            const double v = double(row) / family.orbit_rows();
            const std::size_t at =
                4 * (std::size_t(row) * std::size_t(map.places.width) + std::size_t(octave * kColumns));
            const double zeta = double(map.places.texels[at]) * (1 - v), wanted = orbit->zeta_at(v * ray.phi_end);
            worst = std::fmax(worst, std::fabs(zeta - wanted));
        }
    }
    fmt::print("formula, Kottler: places of the orbit table off by {:.2g} at most\n", worst);
    CHECK(worst < kPlace);
}

TEST_CASE("formula: two horizons are found however close they are, and double zeros") {
    const auto refusal = [](const std::string& a) {
        const auto made = make_spacetime("formula", formulas(a));
        return made ? std::string() : made.error().message();
    };
    for (const double apart : {0.3, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const std::string pair = fmt::format("(1 - 0.6/r)*(1 - {:.17g}/r)", 0.6 * (1 - apart));
        CAPTURE(pair);
        const World world = formula_world("formula", formulas(pair));
        CHECK(*world.spacetime->horizon_radius() == doctest::Approx(0.6).epsilon(1e-9));
        CHECK(*world.reference->orbits()->horizon_radius() == doctest::Approx(0.6).epsilon(1e-12));
        const RayFamily family = fan_at_rest(world, 12);
        CHECK(worst_sweep(world, family, 12, false, {Segment::kSky}) < 4e-9);
        // Angles at the horizon itself, which is all but a double zero of A.
        CHECK(worst_sweep(world, family, 12, false, {Segment::kCaptured}) < 3e-5);
        // A third zero further in is not taken for the horizon.
        const auto third = make_spacetime("formula", formulas(pair + "*(1 - 0.1/r)"));
        REQUIRE_MESSAGE(third, third.error().message());
        CHECK(*test::spherical(*third)->horizon_radius() == doctest::Approx(0.6).epsilon(1e-9));
    }
    // Double zeros, and what comes close to one but has no horizon, are left to open_formula_metric.h.
    for (const std::string twice :
         {"(1 - 0.6/r)^2", "1 - 1.2/r + 0.36/r^2", "1 - 1.2000000001/r + 0.36000000006/r^2"}) {
        CHECK_MESSAGE(refusal(twice).empty(), refusal(twice));
        CHECK(*test::spherical(*make_spacetime("formula", formulas(twice)))->horizon_radius() ==
              doctest::Approx(0.6).epsilon(1e-7));
    }
    for (const std::string above : {"(1 - 0.6/r)^2 + 1e-9", "(1 - 0.6/r)^2 + 1e-9/r^4"}) {
        CHECK_MESSAGE(refusal(above).empty(), refusal(above));
        CHECK_FALSE(test::spherical(*make_spacetime("formula", formulas(above)))->horizon_radius());
    }
    // Between a cosmological horizon and the hole's there may be little room, or none: 4/9 is where they meet.
    CHECK(refusal("1 - 1/r - 0.14814/r^2*r^4").empty());
    CHECK(refusal("1 - 1/r - 0.14815*r^2").find("nowhere above 0") != std::string::npos);
}

TEST_CASE("formula: circular orbits, and where there are none") {
    const auto kottler = test::spherical(*make_spacetime("formula", formulas(kKottler)));
    for (const double r : {2.0, 4.0, 9.0, 15.0})  // Omega^2 = 1/(2 r^3) - Lambda/3
        CHECK(circular_orbit(*kottler, r)->omega ==
              doctest::Approx(std::sqrt(0.5 / (r * r * r) - 0.0002 / 3)).epsilon(1e-12));
    const double most = std::cbrt(1.5 / 0.0002);  // Omega = 0
    CHECK(outermost_circular_orbit(*kottler) == doctest::Approx(most).epsilon(1e-9));
    CHECK_FALSE(circular_orbit(*kottler, 1.001 * most));
    const auto hole = *make_spacetime("formula", formulas("1 - 1/r"));
    CHECK(*innermost_stable_orbit(*hole) == doctest::Approx(3).epsilon(1e-12));
    CHECK(*innermost_stable_orbit(*kottler) > 3.0);
    CHECK(*innermost_stable_orbit(*kottler) < 3.02);
    // Above Lambda M^2/3 = 4/16875 no circular orbit is stable (Stuchlik and Hledik 1999): M = 1/2.
    constexpr double kMost = 3 * 4 * 4.0 / 16875;
    CHECK((*make_spacetime("formula", formulas(fmt::format("1 - 1/r - {}*r^2/3", 0.99 * kMost))))->can_have_disc());
    const auto strong = *make_spacetime("formula", formulas(fmt::format("1 - 1/r - {}*r^2/3", 1.01 * kMost)));
    CHECK_FALSE(strong->can_have_disc());
    CHECK(strong->can_have_bodies());
}

TEST_CASE("formula: what is no hole is refused, with the key and what is allowed") {
    const auto refused = [](const MetricParameters& parameters, const std::string& words) {
        const auto made = make_spacetime("formula", parameters);
        CAPTURE(words);
        REQUIRE_FALSE(made);
        const std::string& message = made.error().message();
        CHECK_MESSAGE(message.find(words) != std::string::npos, message);
        CHECK(message.find('\n') == std::string::npos);
    };
    refused(formulas("1 - "), "A: column");
    refused(formulas("-1 - 1/r"), "A: is nowhere above 0");
    refused(formulas("1 - 1/r + r^2/100"), "A: grows as r^2");
    refused(formulas("1 - 1/r - r^2/6"), "A: is nowhere above 0");
    refused(formulas("max(1 - 1/r, 0)"), "A: max is not smooth");
    refused(formulas("1 - 1/r + 0.265/r^2 - 0.0004/r^6"), "A: light can circle at r = 0.93");
    refused(formulas("1 - 1/r", "-1"), "B: A B is -");
    refused(formulas("1 - 1/r", "1/(1 - 1/r)", "r - 1e-5*r^2"), "R: is -");
    refused(formulas("1 - 1/r", "", "2 + 0*r"), "R: space does not widen far out");
    MetricParameters other = formulas("1 - 1/r");
    other.formulas["C"] = "1";
    refused(other, "no parameter \"C\"");
    CHECK_FALSE(make_spacetime("kerr", formulas("1 - 1/r")));
}

}  // namespace
