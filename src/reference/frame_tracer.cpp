#include "reference/frame_tracer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "camera/pose.h"
#include "reference/spin_bodies.h"
#include "scene/moving.h"
#include "scene/observer.h"
#include "scene/sides.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

// Of a ray about a spinning hole: each half turn nearer to the critical ray brings one more, down to what a double can tell.
constexpr int kMostCrossings = 16;

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

Status check_disc(const DiscSpec& disc) {
    if (!(disc.inner > 0 && disc.inner < disc.outer && std::isfinite(disc.outer))) {
        return bad_input(
            fmt::format("disc: 0 < inner < outer is required, not inner = {}, outer = {}", disc.inner, disc.outer));
    }
    if (!(disc.opacity >= 0 && disc.opacity <= 1)) {
        return bad_input(fmt::format("disc: opacity = {} must lie in [0, 1]", disc.opacity));
    }
    return Done{};
}

using Tetrad = std::array<std::array<long double, 4>, 4>;  // rows e_0, right, up, backward

// Components along the local frame: of a static camera they are known; others go through the metric. By spherical symmetry they do
// not depend on theta: taken at the equator, where the coordinates are regular, they hold on the axis too. Along the rain frame
// e_0 = (1/(1+w), -w), e_1 = (1/(1+w), 1) of (v, r), or the static one (1/s, 0), (1/s, s), s = sqrt(A), the metric
// -A dv^2 + 2 dv dr gives those of (p^v, p^r).
Result<Tetrad> local_tetrad(const Spacetime& spacetime, CameraSpec camera, bool from_rain) {
    const bool spins = !spacetime.planar_rays();
    if (!spins) camera.theta = M_PI / 2;
    const bool rests = camera.observer == ObserverKind::kStatic;
    const auto pair = spins   ? ingoing_hat_pair(spacetime, camera)
                      : rests ? camera_rows_pair(camera)
                              : ingoing_tetrad_pair(spacetime, camera);
    if (!pair) return pair.error();
    const double lapse2 = spacetime.lapse_squared(camera.r), radius = spacetime.areal_radius(camera.r);
    const long double w = std::sqrt(static_cast<long double>(std::fmax(1 - lapse2, 0))),
                      s = std::sqrt(static_cast<long double>(std::fmax(lapse2, 0)));
    Tetrad tetrad{};
    for (std::size_t i = 0; i < 4; ++i) {
        auto& row = tetrad[i];
        for (std::size_t mu = 0; mu < 4; ++mu) row[mu] = static_cast<long double>(pair->high[i][mu]) + pair->low[i][mu];
        if (rests || spins) continue;
        const long double v = row[0], r = row[1];
        if (from_rain)
            row[0] = v - r / (1 + w), row[1] = w * v + r / (1 + w);
        else
            row[0] = s * v - r / s, row[1] = r / s;
        row[2] *= radius, row[3] *= radius;
    }
    return tetrad;
}

}  // namespace

Result<FrameTracer> FrameTracer::make(const Scene& scene) {
    FrameTracer tracer;
    tracer.camera_ = scene.camera;
    tracer.light_ = scene.light;
    tracer.disc_ = scene.disc;
    const CameraSpec& camera = scene.camera;
    if (camera.width < 1 || camera.height < 1) {
        return bad_input(fmt::format("camera: size {}x{} must be at least 1x1", camera.width, camera.height));
    }
    if (!(camera.theta >= 0 && camera.theta <= M_PI && std::isfinite(camera.phi))) {
        return bad_input(
            fmt::format("camera: theta = {} must lie in [0, pi] and phi = {} be finite", camera.theta, camera.phi));
    }
    if (scene.disc) {
        if (Status ok = check_disc(*scene.disc); !ok) return ok.error();
    }
    auto metric = make_orbit_metric(scene.spacetime);
    if (!metric) return metric.error();
    auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!spacetime) return spacetime.error();
    if (Status followed = check_bodies(scene, **metric); !followed) return followed.error();
    if (Status sides = check_sides(**spacetime, scene); !sides) return sides.error();
    if (const auto observer = observer_of(**spacetime, camera); !observer) return observer.error();
    if (Status parts = check_light_parts(**spacetime, scene); !parts) return parts.error();
    tracer.from_rain_ = falls(camera) && (*spacetime)->lapse_squared(camera.r) <= 1;
    auto tetrad = local_tetrad(**spacetime, camera, tracer.from_rain_);
    if (!tetrad) return tetrad.error();
    tracer.velocity_ = tetrad->front();
    if (!scene.light.aberration) {
        CameraSpec still = camera;
        still.velocity = {0, 0, 0};
        still.observer = ObserverKind::kStatic;
        tetrad = local_tetrad(**spacetime, still, false);
        if (!tetrad) return tetrad.error();
    }
    tracer.tetrad_ = *tetrad;
    if (scene.disc && !(*spacetime)->can_have_disc())
        return bad_input(
            fmt::format("metric \"{}\" has no discs; allowed: a scene without [disc]", scene.spacetime.metric));
    tracer.matter_ = tracer.metric_ = std::move(*metric);
    tracer.lapse_ = tracer.matter_->lapse(camera.r);
    tracer.bodies_ = std::make_shared<Bodies>(scene, *tracer.matter_);
    tracer.late_ = scene.light.delay && !moving_parts(scene).empty();
    tracer.disc_moves_ = scene.disc && (scene.spot || scene.disc->flow != DiscFlowKind::kStill);
    if (!scene.light.lensing) {
        tracer.metric_ = std::move(*make_orbit_metric({"minkowski", {}}));
        tracer.camera_.r = (*spacetime)->areal_radius(camera.r);
    }
    return tracer;
}

CameraRay FrameTracer::ray(double x, double y) const {
    const Vec3 look = pixel_direction(camera_, x, y);
    const long double norm =
        std::sqrt(static_cast<long double>(look.x) * look.x + static_cast<long double>(look.y) * look.y +
                  static_cast<long double>(look.z) * look.z);
    const std::array<long double, 3> n{look.x / norm, look.y / norm, look.z / norm};
    std::array<long double, 4> p = tetrad_[0];
    for (int i = 0; i < 3; ++i) {
        for (int mu = 0; mu < 4; ++mu) p[mu] -= n[i] * tetrad_[i + 1][mu];
    }
    if (metric_->spin() != 0) {
        const double azimuth = camera_.phi + (falls(camera_) ? 0 : kerr_azimuth_ahead(metric_->spin(), camera_.r));
        BodyWatch bodies(*bodies_, late_);
        KerrRay traced = trace_kerr(metric_->spin(), KerrPhoton{camera_.r, camera_.theta, azimuth, p},
                                    disc_ ? kMostCrossings : 0, falls(camera_), bodies.watch());
        const double g = 1 / traced.energy, l_z = traced.l_z;
        return {nullptr,     RayPlane(camera_.theta, camera_.phi, {1, 0, 0}), Shift{1, g}, g, l_z, 0, std::move(traced),
                bodies.hit()};
    }
    // The photon is null: its frequency in the local frame is the length of its spatial part.
    const long double across = std::sqrt(p[2] * p[2] + p[3] * p[3]),
                      frequency = std::sqrt(p[1] * p[1] + across * across);
    const LocalRay local{camera_.r, static_cast<double>(-p[1] / frequency), static_cast<double>(across / frequency)};
    const Vec3 direction{local.n_r, static_cast<double>(-p[2] / frequency), static_cast<double>(-p[3] / frequency)};
    RainOrbit start = from_rain_ ? metric_->from_rain(local)
                                 : RainOrbit{metric_->from_static(local), 1 / (light_.lensing ? lapse_ : 1)};
    // The photon moves along p: L_phi = r p^phi in the local tetrad, L_z = L_phi sin(theta), all over E = frequency / start.g.
    const double scale = camera_.r * start.g / static_cast<double>(frequency);
    // The camera's frequency over the local frame's is 1/frequency; without aberration that of the camera's true motion for this ray.
    const auto& u = velocity_;
    const long double doppler =
        light_.aberration ? 1 / frequency : (u[0] * frequency - u[1] * p[1] - u[2] * p[2] - u[3] * p[3]) / frequency;
    // Where nobody is at rest there are no two parts: all of g counts as motion's.
    const double rest = lapse_ > 0 ? lapse_ : 1;
    const Shift shift = from_rain_ ? Shift{1 / rest, static_cast<double>(doppler) * start.g * rest}
                                   : Shift{1 / lapse_, static_cast<double>(doppler)};
    const double l_phi = scale * static_cast<double>(p[3]), l = scale * static_cast<double>(across);
    return {std::move(start.orbit),
            RayPlane(camera_.theta, camera_.phi, direction),
            shift,
            shift.seen(light_),
            l_phi * std::sin(camera_.theta),
            l * l,
            {}};
}

std::unique_ptr<Orbit> FrameTracer::orbit_of(Vec3 look) const {
    const LocalRay local{camera_.r, look.x, std::hypot(look.y, look.z)};
    return from_rain_ ? metric_->from_rain(local).orbit : metric_->from_static(local);
}

std::optional<std::array<double, 2>> FrameTracer::position(Vec3 look) const {
    // The photon p = (1, -look) in the local tetrad is omega (e_0 - n^i e_i): n_i = (p . e_i) / (p . e_0), as e_0 . e_0 = -1.
    const auto product = [&](int i) {
        return -tetrad_[i][0] - look.x * tetrad_[i][1] - look.y * tetrad_[i][2] - look.z * tetrad_[i][3];
    };
    const long double ahead = -product(3) / product(0);  // the third axis points backward
    if (!(ahead > 0)) return std::nullopt;
    const long double pixel = camera_.plane_width / camera_.width / camera_.focal_distance;
    const long double x = product(1) / product(0) / (ahead * pixel), y = product(2) / product(0) / (ahead * pixel);
    return std::array{0.5 * camera_.width + static_cast<double>(x), 0.5 * camera_.height - static_cast<double>(y)};
}

std::vector<DiscHit> FrameTracer::disc_hits(const CameraRay& ray, int max_hits) const {
    std::vector<DiscHit> hits;
    if (!disc_) return hits;
    if (ray.spun) {
        for (const KerrRay::Crossing& c : ray.spun->crossings)
            if (c.r >= disc_->inner && c.r <= disc_->outer && static_cast<int>(hits.size()) < max_hits)
                hits.push_back({c.along, c.r * std::cos(c.phi), c.r * std::sin(c.phi), c.radial > 0, c.radial, c.late});
        return hits;
    }
    std::optional<LightClock> clock;
    if (late_ && disc_moves_) clock.emplace(this->clock(ray));
    for (int k = 1; static_cast<int>(hits.size()) < max_hits; ++k) {
        const double angle = ray.plane.crossing(k);
        if (!(angle < ray.orbit->angle())) break;
        const double r = 1 / ray.orbit->zeta_at(angle);
        if (!(r >= disc_->inner && r <= disc_->outer)) continue;
        const double phi = ray.plane.azimuth(angle);
        // Traced inward is really moving outward.
        const double before = ray.orbit->zeta_at(angle * (1 - 1e-6));
        hits.push_back({angle, r * std::cos(phi), r * std::sin(phi), 1 / r > before, kNotANumber,
                        clock ? clock->late(angle) : 0.0});
    }
    return hits;
}

LightClock FrameTracer::clock(const CameraRay& ray) const {
    return {*metric_, *ray.orbit, 1 / std::sqrt(ray.l2), camera_.r, falls(camera_)};
}

std::optional<BodyHit> FrameTracer::body_hit(const CameraRay& ray) const {
    if (bodies_->empty() || ray.spun) return ray.met;
    if (!late_ || !bodies_->move())
        return bodies_->first_hit(*ray.orbit, ray.plane, camera_.r, nullptr, metric_->by_proper_length());
    LightClock clock = this->clock(ray);
    return bodies_->first_hit(*ray.orbit, ray.plane, camera_.r, &clock);
}

RayPixel FrameTracer::pixel(double x, double y) const { return pixel_of(ray(x, y), true); }
RayPixel FrameTracer::pixel_without_delay(double x, double y) const { return pixel_of(ray(x, y), false); }

RayPixel FrameTracer::pixel_of(const CameraRay& traced, bool with_delay) const {
    RayPixel pixel;
    pixel.fate = traced.fate();
    pixel.g = traced.g > 0 && std::isfinite(traced.g) ? traced.g
                                                      : 0;  // light of no positive energy has no frequency at infinity
    pixel.angle = traced.spun ? 0.0 : finite_or_zero(traced.orbit->angle());
    if (pixel.fate == Fate::kHit) {  // a star
        const Vec3 place = traced.plane.direction(pixel.angle);
        pixel.hit = kStarHit;
        pixel.u = std::atan2(place.y, place.x);
        pixel.v = std::atan2(place.z, std::hypot(place.x, place.y));
    }
    const std::vector<DiscHit> hits = disc_hits(traced, 1);
    const std::optional<BodyHit> body = body_hit(traced);
    const bool disc_first = !hits.empty() && !(body && body->along < hits.front().along);
    const auto angle = [&](double along) { return traced.spun ? 0.0 : along; };
    if (body) {  // solid: it ends the ray, whatever a translucent disc before it
        pixel.fate = Fate::kHit;
        pixel.angle = angle(body->along);
        pixel.hit = static_cast<int>(body->object);
        pixel.u = body->place.x, pixel.v = body->place.y, pixel.w = body->place.z;
    }
    if (disc_first) {
        pixel.hit = 1;
        pixel.u = hits.front().x;
        pixel.v = hits.front().y;
        pixel.w = 0;
        if (disc_->opacity == 1) {
            pixel.fate = Fate::kHit;
            pixel.angle = angle(hits.front().along);
        }
    }
    if (pixel.fate == Fate::kEscaped || pixel.fate == Fate::kOtherSide) {
        pixel.sky = traced.end();
        if (with_delay) pixel.delay = finite_or_zero(traced.spun ? traced.spun->delay : traced.orbit->delay());
    }
    if (with_delay && traced.spun && pixel.fate == Fate::kHit)
        pixel.delay = disc_first && disc_->opacity == 1 ? hits.front().late : body->late;
    if (with_delay && !traced.spun && (pixel.fate == Fate::kHit) && pixel.hit != kStarHit &&
        !metric_->by_proper_length())
        pixel.delay = finite_or_zero(clock(traced).late(pixel.angle));
    pixel.order =
        static_cast<int>(std::min(std::floor(pixel.angle / M_PI), 1e9));  // in a wormhole's tube rays wind without end
    return pixel;
}

}  // namespace nullscope::reference
