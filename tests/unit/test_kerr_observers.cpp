// Who can hold a camera about a rotating hole: tetrads, constants of motion, and where nobody can.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/spin_forms.h"
#include "reference/kerr_ray.h"
#include "reference/reference.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "support/metrics.h"
#include "support/observer.h"

namespace {

using namespace nullscope;
using test::kerr;
using enum ObserverKind;
using Components = std::array<long double, 4>;

constexpr double kPromised = 1e-12;  // of products of a tetrad, and of constants of motion
constexpr ObserverKind kAll[] = {kStatic, kZamo, kCarter, kOrbit, kCounterOrbit, kRain, kFall, kThrow};

CameraSpec camera_at(double r, double theta, ObserverKind observer, Vec3 velocity = {}) {
    CameraSpec camera;
    camera.r = r, camera.theta = theta, camera.observer = observer, camera.velocity = velocity;
    camera.yaw = 0.3, camera.pitch = -0.2, camera.roll = 0.1, camera.fall_from = 8, camera.energy = 1.7;
    return camera;
}

Components row(const TetradPair& tetrad, std::size_t i) {
    Components v{};
    for (std::size_t mu = 0; mu < 4; ++mu) v[mu] = static_cast<long double>(tetrad.high[i][mu]) + tetrad.low[i][mu];
    return v;
}
long double product(const Matrix4& g, const Components& a, const Components& b) {
    long double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum += g[i][j] * a[i] * b[j];
    return sum;
}

// Of a 4-velocity or a photon: -p_v, p_phi/sin(theta), p_theta.
struct Constants {
    double energy, across, p_theta;
};
Constants constants(const Spacetime& spacetime, const CameraSpec& camera, const Components& p) {
    const Matrix4 g = ingoing_hat_metric(spacetime, camera.r, camera.theta);
    return {static_cast<double>(-product(g, {1, 0, 0, 0}, p)), static_cast<double>(product(g, {0, 0, 0, 1}, p)),
            static_cast<double>(product(g, {0, 0, 1, 0}, p))};
}

}  // namespace

TEST_CASE("kerr observers: orthonormal outside, on and inside the horizon, and on the axis") {
    for (const double spin : {1e-6, 0.5, 0.9, 0.9999})
        for (const double above : {50.0, 2.0, 0.3, 1e-7, 0.0, -1e-7, -0.05, -0.4})
            for (const double theta : {0.0, 0.7, M_PI / 2, 3.0})
                for (const ObserverKind kind : kAll)
                    for (const Vec3 v : {Vec3{}, Vec3{0.3, -0.5, 0.6}}) {
                        const CameraSpec camera = camera_at(*kerr(spin)->horizon_radius() + above, theta, kind, v);
                        const auto tetrad = ingoing_hat_pair(*kerr(spin), camera);
                        if (!tetrad) continue;
                        const Matrix4 g = ingoing_hat_metric(*kerr(spin), camera.r, theta);
                        CAPTURE(spin);
                        CAPTURE(camera.r);
                        CAPTURE(std::string(observer_name(kind)));
                        // What is summed: next to the horizon those who stay there have large components.
                        double size = 1;
                        for (std::size_t i = 0; i < 4; ++i)
                            for (const double x : tetrad->high[i]) size = std::max(size, x * x);
                        for (std::size_t i = 0; i < 4; ++i)
                            for (std::size_t j = 0; j < 4; ++j)
                                CHECK(std::fabs(static_cast<double>(product(g, row(*tetrad, i), row(*tetrad, j))) -
                                                (i != j   ? 0.0
                                                 : i == 0 ? -1.0
                                                          : 1.0)) < kPromised * std::max(1.0, 1e-2 * size));
                    }
}

TEST_CASE("kerr observers: each has the constants of motion that define it") {
    for (const double spin : {0.3, 0.9, 0.998})
        for (const double r : {0.45, 0.8, 1.4, 3.0, 20.0})
            for (const double theta : {0.4, M_PI / 2, 2.2})
                for (const ObserverKind kind : kAll) {
                    const auto spacetime = kerr(spin);
                    const CameraSpec camera = camera_at(r, theta, kind);
                    const auto tetrad = ingoing_hat_pair(*spacetime, camera);
                    if (!tetrad) continue;
                    CAPTURE(spin);
                    CAPTURE(r);
                    CAPTURE(std::string(observer_name(kind)));
                    const Components u = row(*tetrad, 0);
                    const Constants c = constants(*spacetime, camera, u);
                    const double a = spacetime->a(), scale = kPromised * (1 + std::fabs(c.energy) * r);
                    CHECK(std::fabs(c.p_theta) < scale);
                    if (kind == kStatic)
                        CHECK(std::fabs(static_cast<double>(u[3])) + std::fabs(static_cast<double>(u[1])) < kPromised);
                    if (kind == kCarter) CHECK(std::fabs(c.across - a * c.energy * std::sin(theta)) < scale);
                    if (kind == kZamo || falls(camera)) CHECK(std::fabs(c.across) < scale);
                    if (kind == kRain) CHECK(std::fabs(c.energy - 1) < kPromised);
                    if (kind == kThrow) CHECK(std::fabs(c.energy - 1.7) < kPromised);
                    if (kind == kFall)
                        CHECK(std::fabs(c.energy - std::sqrt(-1 / spacetime->inverse_metric(8, theta)[0][0])) <
                              kPromised);
                    if (falls(camera)) CHECK(u[1] < 0);
                    if (kind == kOrbit ||
                        kind == kCounterOrbit) {  // r' = r'' = 0 of the radial potential, by differences of it
                        CHECK(std::fabs(static_cast<double>(u[1])) < kPromised);
                        const double w = c.across - a * c.energy * std::sin(theta),
                                     k = a * a * std::pow(std::cos(theta), 2) + w * w, l = c.across * std::sin(theta);
                        const auto potential = [&](double x) {
                            return std::pow(c.energy * (x * x + a * a) - a * l, 2) - (x * x - x + a * a) * (x * x + k);
                        };
                        const double h = 1e-4 * r;
                        CHECK(std::fabs(potential(r + h) - potential(r - h)) / (2 * h) <
                              1e-6 * r * r * r * c.energy * c.energy);
                        if (theta == M_PI / 2 && kind == kOrbit) {
                            const CircularOrbit circle = *circular_orbit(*spacetime, r);
                            CHECK(c.energy == doctest::Approx(circle.energy).epsilon(1e-11));
                            CHECK(c.across == doctest::Approx(circle.momentum).epsilon(1e-11));
                        }
                        CHECK((l > 0) == (kind == kOrbit));
                    }
                }
}

TEST_CASE("kerr observers: the forms of a view direction are the photon of the tetrad, on the horizon and inside too") {
    for (const double spin : {0.3, 0.9, 0.9999})
        for (const double above : {3.0, 0.2, 1e-6, 0.0, -1e-6, -0.2})
            for (const double theta : {0.0, 0.7, M_PI / 2})
                for (const ObserverKind kind : kAll) {
                    const auto spacetime = kerr(spin);
                    CameraSpec camera = camera_at(*spacetime->horizon_radius() + above, theta, kind);
                    camera.yaw = camera.pitch = camera.roll = 0;  // right e_phi, up -e_theta, backward e_r
                    const auto observer = observer_of(*spacetime, camera);
                    const auto tetrad = ingoing_hat_pair(*spacetime, camera);
                    if (!observer || !tetrad) continue;
                    CAPTURE(spin);
                    CAPTURE(camera.r);
                    CAPTURE(std::string(observer_name(kind)));
                    const SpinPlace place = spin_place(*spacetime, camera.r, theta);
                    const SpinForms f = spin_forms(place, {observer->frame, observer->azimuthal_velocity});
                    const Vec3 n = normalized(Vec3{0.4, -0.5, 0.3});
                    Components p = row(*tetrad, 0);
                    for (std::size_t mu = 0; mu < 4; ++mu)
                        p[mu] += -n.z * row(*tetrad, 1)[mu] + n.y * row(*tetrad, 2)[mu] - n.x * row(*tetrad, 3)[mu];
                    const Constants c = constants(*spacetime, camera, p);
                    double size = 1;
                    for (const long double x : p) size = std::max(size, std::fabs(static_cast<double>(x)));
                    const double bound = 1e-13 * size * std::max(1.0, camera.r);
                    CHECK(std::fabs(f.energy.of(n.x, n.z) + c.energy) < bound);
                    CHECK(std::fabs(f.across.of(n.x, n.z) + c.across) < bound);
                    CHECK(std::fabs(f.p_theta * n.y + c.p_theta) < bound);
                    CHECK(std::fabs(f.carter + f.carter_slope * n.z + c.across - place.a * place.sine * c.energy) <
                          bound);
                    CHECK(std::fabs(f.climb.of(n.x, n.z) -
                                    place.sigma * static_cast<double>(p[1]) / (camera.r * camera.r)) < bound);
                }
}

TEST_CASE("kerr observers: without spin the frames are those of the radial observers") {
    const std::shared_ptr<const Spacetime> slow = kerr(1e-12), none = *make_spacetime("kerr", {{"spin", 0.0}});
    for (const double r : {0.2, 0.7, 1.3, 2.0, 5.0, 7.9})
        for (const ObserverKind kind : kAll) {
            const CameraSpec camera = camera_at(r, 1.1, kind, {0.1, 0.2, -0.3});
            const auto a = ingoing_hat_pair(*slow, camera), b = ingoing_hat_pair(*none, camera);
            CAPTURE(r);
            CAPTURE(std::string(observer_name(kind)));
            CHECK(static_cast<bool>(a) == static_cast<bool>(b));
            if (!a || !b) continue;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t mu = 0; mu < 4; ++mu)
                    CHECK(std::fabs(static_cast<double>(row(*a, i)[mu] - row(*b, i)[mu])) <
                          1e-10 * std::max(1.0, std::fabs(static_cast<double>(row(*b, i)[mu]))));
        }
}

TEST_CASE("kerr observers: where there are none one line says what is allowed") {
    const auto spacetime = kerr(0.9);
    const auto refused = [&](double r, double theta, ObserverKind kind) -> std::string {
        CameraSpec camera = camera_at(r, theta, kind);
        camera.energy = 0.5;
        const auto observer = observer_of(*spacetime, camera);
        return observer ? "" : observer.error().message();
    };
    CHECK(refused(0.95, M_PI / 2, kStatic).find("ergosphere; allowed: r > 1 at this theta, or observer = \"zamo\"") !=
          std::string::npos);
    CHECK(refused(0.95, M_PI / 2, kZamo).empty());
    CHECK(refused(0.95, 0.1, kStatic).empty());  // the ergosphere ends at the horizon on the axis
    CHECK(refused(0.7, 1, kZamo).find("allowed: r > 0.717") != std::string::npos);
    CHECK(refused(0.7, 1, kRain).empty());
    CHECK(refused(0.25, 1, kRain).find("allowed: r > 0.282") != std::string::npos);  // the inner horizon
    CHECK(refused(0.75, M_PI / 2, kOrbit).find("no orbit of this sense") != std::string::npos);
    CHECK(refused(0.80, M_PI / 2, kOrbit).empty());  // light's own, with the spin: 0.7789
    CHECK(refused(1.90, M_PI / 2, kCounterOrbit).find("no orbit of this sense") != std::string::npos);
    CHECK(refused(1.97, M_PI / 2, kCounterOrbit).empty());  // against it: 1.9551
    CHECK(refused(9.0, 1, kFall).find("fall_from >= camera.r") != std::string::npos);
    CHECK(refused(3.0, 1, kThrow).find("does not come this far in") != std::string::npos);
    CHECK(refused(0.9, 1, kThrow).empty());
}

TEST_CASE("kerr observers: both have the same azimuth of what falls in") {
    for (const double spin : {0.1, 0.9, 0.9999})
        for (const double r : {*kerr(spin)->horizon_radius() * (1 + 1e-6), 1.5, 40.0})
            CHECK(kerr(spin)->azimuth_ahead(r) ==
                  doctest::Approx(reference::kerr_azimuth_ahead(spin, r)).epsilon(1e-9));
}

// As a difference it has no digits next to the horizon: compared where it has.
TEST_CASE("kerr observers: what of the energy does not go round with the horizon") {
    for (const double spin : {0.1, 0.9, 0.9995})
        for (const double horizons : {0.8, 1.2, 3.0})
            for (const ObserverKind kind : kAll) {
                const auto spacetime = kerr(spin);
                const double outer = spacetime->outer_horizon(),
                             girth = outer * outer + spacetime->a() * spacetime->a();
                const CameraSpec camera = camera_at(horizons * outer, 1.1, kind);
                const auto observer = observer_of(*spacetime, camera);
                if (!observer) continue;
                const SpinPlace place = spin_place(*spacetime, camera.r, camera.theta);
                const SpinFrame frame{observer->frame, observer->azimuthal_velocity};
                const SpinForms forms = spin_forms(place, frame);
                const SpinForm form = horizon_form(*spacetime, place, frame);
                for (const double n_r : {-0.9, 0.1, 0.7})
                    for (const double n_phi : {-0.4, 0.3}) {
                        const double energy = -forms.energy.of(n_r, n_phi),
                                     momentum = -forms.across.of(n_r, n_phi) * place.sine,
                                     size =
                                         (std::fabs(energy) * girth + std::fabs(place.a * momentum)) / (outer * outer);
                        CHECK(std::fabs(form.of(n_r, n_phi) - (energy * girth - place.a * momentum) / (outer * outer)) <
                              kPromised * std::max(1.0, size));
                    }
            }
}

// Only which side of the horizon it is on decides whether what does not come out is dark or another sky: the place in the tracer's own coordinates
// is rounded anew for each theta, above the horizon or below.
TEST_CASE("kerr observers: one on the horizon sees what one just inside sees") {
    constexpr int kThetas = 16;
    constexpr double kJustInside = 1e-9;
    for (const MetricParameters& hole :
         {MetricParameters({{"spin", 0.9}, {"charge", 0.0}}), MetricParameters({{"spin", 0.6}, {"charge", 0.6}}),
          MetricParameters({{"spin", 0.05}, {"charge", 0.99}})}) {
        Scene scene;
        scene.spacetime = {"kerr-newman", hole};
        scene.sky.kind = SkyKind::kBlack;
        scene.camera = camera_at(1, 1, kRain);
        scene.camera.yaw = scene.camera.pitch = scene.camera.roll = 0;
        scene.camera.width = 5, scene.camera.height = 3;
        const double horizon = *(*make_spacetime(scene.spacetime.metric, scene.spacetime.parameters))->horizon_radius();
        for (int i = 1; i < kThetas; ++i) {
            scene.camera.theta = i * M_PI / kThetas;
            scene.camera.r = horizon;
            const auto on = reference::trace_frame(scene);
            scene.camera.r = horizon * (1 - kJustInside);
            const auto inside = reference::trace_frame(scene);
            REQUIRE(on);
            REQUIRE(inside);
            CAPTURE(hole.at("spin"));
            CAPTURE(scene.camera.theta);
            CHECK(std::ranges::equal(on->pixels, inside->pixels, {}, &RayPixel::fate, &RayPixel::fate));
        }
    }
}
