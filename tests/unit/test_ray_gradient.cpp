// Derivatives of rays (src/gradient) against central differences of the reference, which shares no code with them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "gradient/disc_motion.h"
#include "gradient/parameter.h"
#include "gradient/ray_gradient.h"
#include "observer/pose.h"
#include "reference/disc_light.h"
#include "reference/metric.h"
#include "reference/reference.h"
#include "scene/projection.h"
#include "support/depth.h"

namespace {

using namespace nullscope;

constexpr int kAskedCrossings = 2;
constexpr double kPixel = 1e-3;       // rad, of a picture of some thousand
constexpr double kNearEdge = 0.1;     // of a pixel, from the critical curve
constexpr double kWidestStep = 1e-3;  // of differences, where nothing is near
constexpr double kBound = 1e-6;       // of the derivative or
constexpr double kLeastSize = 0.1;    // of this, in radii, times and directions by rad, r_s or 1
constexpr double kSameValue = 1e-9;

struct GradientCase {
    const char* metric;
    MetricParameters parameters;
    double least_r;
};

Scene scene_of(const GradientCase& of, std::mt19937_64& random) {
    std::uniform_real_distribution<double> angle(-1.0, 1.0);
    Scene scene;
    scene.spacetime = {of.metric, of.parameters};
    scene.disc = DiscSpec{.opacity = 0.5, .emission = DiscEmission::kThermal};
    scene.disc->lean = {0.4, 0.5, 0.01};
    scene.time = 30.0;
    scene.camera.yaw = angle(random), scene.camera.pitch = 0.4 * angle(random), scene.camera.roll = angle(random);
    return scene;
}

RayQuery ray_of(const GradientCase& of, std::mt19937_64& random) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::normal_distribution<double> around;
    RayQuery ray;
    ray.r = of.least_r * std::pow(20.0 / of.least_r, part(random));
    ray.theta = std::acos(1.8 * part(random) - 0.9), ray.phi = 6.0 * part(random) - 3.0;
    // Most towards the hole, where light bends most.
    ray.n = normalized(Vec3{-part(random), (1 + 1 / ray.r) * 0.5 * around(random), 0.5 * around(random)});
    return ray;
}

// What trace prints; not a number where there is none.
constexpr std::size_t kRayValues = 5, kOfCrossing = 3;
constexpr std::size_t kValues = kRayValues + kOfCrossing * kAskedCrossings;
using Values = std::array<double, kValues>;
constexpr std::array<const char*, kValues> kValueNames = {"x",     "y",   "z",   "g",     "delay", "r_1",
                                                          "phi_1", "g_1", "r_2", "phi_2", "g_2"};

// The reference's matter of the disc, which gives crossings their g.
class KnownMatter {
public:
    explicit KnownMatter(const Scene& scene) : metric_(std::move(*reference::make_metric(scene.spacetime))) {
        DiscSpec disc = *scene.disc;
        disc.outer = 1e-2, disc.inner = 1e-3;  // no table of its heat is made
        light_ = std::make_unique<reference::DiscLight>(*metric_, disc, scene.light);
    }
    const reference::DiscLight& light() const { return *light_; }

private:
    std::unique_ptr<reference::Metric> metric_;
    std::unique_ptr<reference::DiscLight> light_;
};

Values reference_values(const Scene& scene, const RayQuery& ray, const KnownMatter& matter) {
    const auto record = reference::trace_ray(scene, ray, kAskedCrossings, &matter.light());
    REQUIRE(record);
    Values v;
    v.fill(kNotANumber);
    v[0] = record->sky.x, v[1] = record->sky.y, v[2] = record->sky.z, v[3] = record->g, v[4] = record->delay;
    for (std::size_t k = 0; k < std::min<std::size_t>(kAskedCrossings, record->crossings.size()); ++k)
        v[5 + 3 * k] = record->crossings[k].r, v[6 + 3 * k] = record->crossings[k].phi,
                  v[7 + 3 * k] = record->crossings[k].g;
    return v;
}

Values values_of(const RayGradient& ray, const DiscMotion& motion) {
    Values v;
    v.fill(kNotANumber);
    v[3] = ray.g.value;
    if (ray.sky) {
        for (std::size_t i = 0; i < 3; ++i) v[i] = ray.sky->direction[i].value;
        v[4] = ray.sky->delay.value;
    }
    for (std::size_t k = 0; k < ray.crossings.size(); ++k)
        v[5 + 3 * k] = ray.crossings[k].r.value, v[6 + 3 * k] = ray.crossings[k].phi.value,
                  v[7 + 3 * k] = motion.g(ray.photon, ray.crossings[k]).value;
    return v;
}

Values derivatives(const RayGradient& ray, const DiscMotion& motion, const Change& by) {
    Values v;
    v.fill(kNotANumber);
    v[3] = derivative(ray.g, by);
    if (ray.sky) {
        const Vec3 sky = derivative_of_direction(ray.sky->direction, by);
        v[0] = sky.x, v[1] = sky.y, v[2] = sky.z, v[4] = derivative(ray.sky->delay, by);
    }
    for (std::size_t k = 0; k < ray.crossings.size(); ++k)
        v[5 + 3 * k] = derivative(ray.crossings[k].r, by),
                  v[6 + 3 * k] = derivative_of_azimuth(ray.crossings[k].phi, by),
                  v[7 + 3 * k] = derivative(motion.g(ray.photon, ray.crossings[k]), by);
    return v;
}

// The scene and the ray where a parameter is changed, the pixel of the ray kept.
void change(ParameterKind kind, double by, Scene& scene, RayQuery& ray) {
    const Mat3 axes = static_from_camera(scene.camera);
    Vec3 own = transposed(axes) * ray.n;
    const auto add = [&](const char* name) { scene.spacetime.parameters[name] += by; };
    switch (kind) {
        case ParameterKind::kSpin: return add("spin");
        case ParameterKind::kCharge: return add("charge");
        case ParameterKind::kR: ray.r += by; return;
        case ParameterKind::kTheta: ray.theta += by; return;
        case ParameterKind::kPhi: ray.phi += by; return;
        case ParameterKind::kYaw: scene.camera.yaw += by; break;
        case ParameterKind::kPitch: scene.camera.pitch += by; break;
        case ParameterKind::kRoll: scene.camera.roll += by; break;
        case ParameterKind::kFov: {
            const double before = scene.camera.plane_width;
            set_field_of_view(scene.camera, field_of_view(scene.camera) + by);
            own.x *= scene.camera.plane_width / before, own.y *= scene.camera.plane_width / before;
            break;
        }
        case ParameterKind::kTilt: scene.disc->lean.tilt += by; return;
        case ParameterKind::kNode: scene.disc->lean.node += by; return;
        case ParameterKind::kPrecession: scene.disc->lean.precession += by / scene.time; return;
        default: REQUIRE_MESSAGE(false, "a key of light alone"); return;
    }
    ray.n = normalized(static_from_camera(scene.camera) * own);
}

bool changes_matter(ParameterKind kind) {
    return kind == ParameterKind::kSpin || kind == ParameterKind::kCharge || kind == ParameterKind::kTilt;
}

struct Judged {
    double value = 0, error = 0;
};

Values differences(ParameterKind kind, double step, const Scene& scene, const RayQuery& ray,
                   const KnownMatter& matter) {
    const auto at = [&](double by) {
        Scene other = scene;
        RayQuery moved = ray;
        change(kind, by, other, moved);
        return changes_matter(kind) ? reference_values(other, moved, KnownMatter(other))
                                    : reference_values(other, moved, matter);
    };
    Values slope = at(step);
    const Values down = at(-step);
    const double unit = kind == ParameterKind::kPrecession ? 2 * step / scene.time : 2 * step;
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = (slope[i] - down[i]) / unit;
    return slope;
}

// Differences of steps h, h/2, h/4, extrapolated (L. F. Richardson, Phil. Trans. A 210, 307 (1911)): of order 6. error: of order 4, more than is left.
std::array<Judged, kValues> judgement(ParameterKind kind, double step, const Scene& scene, const RayQuery& ray,
                                      const KnownMatter& matter) {
    const Values wide = differences(kind, step, scene, ray, matter),
                 half = differences(kind, step / 2, scene, ray, matter),
                 fourth = differences(kind, step / 4, scene, ray, matter);
    std::array<Judged, kValues> judged;
    for (std::size_t i = 0; i < kValues; ++i) {
        const double first = (4 * half[i] - wide[i]) / 3, second = (4 * fourth[i] - half[i]) / 3;
        judged[i] = {(16 * second - first) / 15, std::fabs(second - first)};
    }
    return judged;
}

struct Tally {
    int rays = 0, near_edge = 0, at_horizon = 0, lost = 0, compared = 0, not_judged = 0;
    double worst = 0;
    std::string where;
};

// Next to the horizon rays cross a leaning plane without end.
bool leave_out_next_to_horizon(Values& known, double horizon) {
    bool any = false;
    for (std::size_t k = kRayValues; k < kValues; k += kOfCrossing)
        if (known[k] < (1 + 1e-5) * horizon) known[k] = known[k + 1] = known[k + 2] = kNotANumber, any = true;
    return any;
}

bool same_values(const Values& own, const Values& known) {
    for (const std::size_t i : {0, 1, 2, 3, 4, 5, 7, 8, 10})  // azimuths of crossings are compared by their derivatives
        if (std::isfinite(known[i]) &&
            !(std::fabs(own[i] - known[i]) < kSameValue * std::max(1.0, std::fabs(known[i]))))
            return false;
    return true;
}

void compare(ParameterKind kind, const std::string& what, const Values& known, const Values& own,
             const std::array<Judged, kValues>& judged, Tally& tally) {
    for (std::size_t i = 0; i < kValues; ++i) {
        if (std::isnan(judged[i].value) || std::isnan(known[i])) continue;
        const double size = std::max(std::fabs(judged[i].value), kLeastSize);
        if (judged[i].error > 0.3 * kBound * size) {
            ++tally.not_judged;
            continue;
        }
        ++tally.compared;
        const double off = std::fabs(own[i] - judged[i].value) / size;
        if (off <= tally.worst) continue;
        tally.worst = std::isnan(off) ? 1.0 : off;
        tally.where = fmt::format("{}: d {}/d parameter {} is {:.12g}, by differences {:.12g} +- {:.1g}", what,
                                  kValueNames[i], static_cast<int>(kind), own[i], judged[i].value, judged[i].error);
    }
}

Tally tally_of(const GradientCase& of, int rays, std::size_t parameters) {
    Tally tally;
    std::mt19937_64 random(7);
    const auto flow = make_flow(of.metric, of.parameters, of.parameters.formulas);
    REQUIRE(flow);
    std::optional<DiscMotion> motion;
    std::optional<KnownMatter> matter;
    for (; tally.rays < rays; ++tally.rays) {
        const Scene scene = scene_of(of, random);
        if (!motion) motion.emplace(**flow, 1.0, scene.disc->lean), matter.emplace(scene);  // of all rays
        const RayQuery ray = ray_of(of, random);
        const LookedAlong view = looked_along(ray.n);
        const RayGradient found =
            ray_gradient(**flow, {ray.r, ray.theta, ray.phi, view}, {scene.disc->lean, scene.time, kAskedCrossings});
        if (found.off_critical < kNearEdge * kPixel) {
            ++tally.near_edge;
            continue;
        }
        Values known = reference_values(scene, ray, *matter);
        if (leave_out_next_to_horizon(known, 1 / (*flow)->innermost())) ++tally.at_horizon;
        if (!same_values(values_of(found, *motion), known)) ++tally.lost;
        const auto names = parameter_names(scene);
        for (std::size_t n = 0; n < std::min(parameters, names.size()); ++n) {
            const std::string name(names[(n + parameters * static_cast<std::size_t>(tally.rays)) % names.size()]);
            const ParameterKind kind = (*parse_parameters({name}, scene))[0].kind;
            compare(kind, fmt::format("{} ray {} {}", of.metric, tally.rays, name), known,
                    derivatives(found, *motion, change_by(kind, view, scene)),
                    judgement(kind, std::min(kWidestStep, 0.02 * found.off_critical), scene, ray, *matter), tally);
        }
    }
    return tally;
}

MetricParameters gradient_formulas(const char* a, const char* b, const char* r) {
    MetricParameters parameters;
    parameters.formulas = {{"A", a}, {"B", b}, {"R", r}};
    return parameters;
}

const GradientCase kGradientCases[] = {
    {"schwarzschild", {}, 1.3},
    {"reissner-nordstrom", MetricParameters({{"charge", 0.8}}), 1.2},
    {"kerr", MetricParameters({{"spin", 0.9}}), 1.3},
    {"kerr-newman", MetricParameters({{"spin", 0.6}, {"charge", 0.6}}), 1.3},
    {"formula", gradient_formulas("1 - 1/r - 0.1/r^3", "1/(1 - 1/r - 0.1/r^3)", "r"), 1.4},
};

TEST_CASE("ray gradients: as differences of the reference, or near an edge") {
    const int rays = test::by_depth(8, 100, 500);
    const std::size_t parameters = test::by_depth(2, 3, 12);
    for (const GradientCase& of : kGradientCases) {
        const Tally tally = tally_of(of, rays, parameters);
        MESSAGE(
            fmt::format("{}: {} rays, {} near the critical curve, {} that cross next to the horizon, {} lost; {} "
                        "derivatives, worst {:.2g}, {} beyond "
                        "what differences tell; {}",
                        of.metric, tally.rays, tally.near_edge, tally.at_horizon, tally.lost, tally.compared,
                        tally.worst, tally.not_judged, tally.where));
        CHECK(tally.worst < kBound);
        CHECK(tally.lost == 0);
        CHECK(tally.near_edge <= 0.01 * rays);
        CHECK(tally.not_judged < 0.05 * tally.compared);
    }
}

// b = r sin(alpha)/sqrt(1 - 1/r), and sqrt(27)/2 on the critical curve.
TEST_CASE("ray gradients: the distance from the critical curve, in the view") {
    const auto flow = make_flow("schwarzschild", {}, {});
    REQUIRE(flow);
    for (const double r : {1.7, 15.0, 1000.0})
        for (const double off : {-1e-3, -1e-6, 1e-6, 1e-3}) {
            const double critical = std::asin(std::sqrt(27.0) / 2 * std::sqrt(1 - 1 / r) / r),
                         alpha = critical * (1 + off);
            const Launch from{r, 1.0, 0.5,
                              looked_along({-std::cos(alpha), 0.6 * std::sin(alpha), 0.8 * std::sin(alpha)})};
            const RayGradient ray = ray_gradient(**flow, from, {});
            CAPTURE(r);
            CAPTURE(off);
            CHECK(ray.off_critical == doctest::Approx(critical * std::fabs(off)).epsilon(0.01));
            CHECK(ray.sky.has_value() == (off > 0));
        }
}

// Of a camera far off that looks away the sky is where it looks, and the delay 0.
TEST_CASE("ray gradients: flat space and far cameras in closed form") {
    const auto flow = make_flow("minkowski", {}, {});
    REQUIRE(flow);
    const LookedAlong view = looked_along(normalized(Vec3{-1, 0.3, 0.2}));
    for (const double r : {3.0, 1e9}) {
        const RayGradient ray = ray_gradient(**flow, {r, 1.1, 0.4, view}, {});
        REQUIRE(ray.sky);
        const Vec3 seen = world_from_static(1.1, 0.4) * view.n;
        CHECK(length(Vec3{ray.sky->direction[0].value, ray.sky->direction[1].value, ray.sky->direction[2].value} -
                     seen) < 1e-11);
        // T = r - n r: along n the light is ahead of what falls in radially.
        CHECK(ray.sky->delay.value == doctest::Approx(r * (1 - view.n.x)).epsilon(1e-10));
        CHECK(ray.sky->delay.d[kSeedR] == doctest::Approx(1 - view.n.x).epsilon(1e-9));
        CHECK(std::fabs(ray.sky->direction[2].d[kSeedR]) < 1e-11 / r);
    }
}

TEST_CASE("ray gradients: what can be asked for, and what not") {
    Scene scene;
    scene.spacetime = {"kerr", MetricParameters({{"spin", 0.5}})};
    const auto both = parse_parameters({"spin", "camera.theta"}, scene);
    REQUIRE(both);
    CHECK((*both)[0].kind == ParameterKind::kSpin);
    CHECK((*both)[1].name == "camera.theta");
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"charge"},
                                                  {"disc.tilt"},
                                                  {"camera.r", "camera.r"},
                                                  {"spin", "spacetime.spin"},
                                                  {""}}) {
        const auto none = parse_parameters(wrong, scene);
        REQUIRE(!none);
        CHECK(none.error().allowed.find("spacetime.spin, camera.r") != std::string::npos);
    }
    scene.camera.projection = Projection::kFisheye;
    CHECK(!parse_parameters({"camera.fov"}, scene));
    CHECK(!make_flow("neutron-star", {}, {}));
    CHECK(!make_flow("formula", {}, {{"A", "1 -"}}));
}

}  // namespace
