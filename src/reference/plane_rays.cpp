#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "observer/observer.h"
#include "reference/medium.h"
#include "reference/plane_metrics.h"
#include "reference/plane_ray.h"
#include "reference/warped_crossings.h"
#include "scene/projection.h"

namespace nullscope::reference {
namespace {

// Outside of this and kLargestRadius the squares of the orbit equation would leave the range of a double.
constexpr double kLeastRadius = 1e-30;

// Components along the local frame: of a static camera they are known; others go through the metric. By spherical
// symmetry they do not depend on theta: taken at the equator, where the coordinates are regular, they hold on the axis
// too. Along the rain frame e_0 = (1/(1+w), -w), e_1 = (1/(1+w), 1) of (v, r), or the static one (1/s, 0), (1/s, s),
// s = sqrt(A), the metric -A dv^2 + 2 dv dr gives those of (p^v, p^r).
Result<Tetrad> local_tetrad(const Spacetime& spacetime, CameraSpec camera, bool from_rain) {
    camera.theta = M_PI / 2;
    const bool rests = camera.observer == ObserverKind::kStatic;
    TRY(pair, rests ? camera_rows_pair(camera) : ingoing_tetrad_pair(spacetime, camera));
    Tetrad tetrad = long_tetrad(*pair);
    if (rests) return tetrad;
    const double lapse2 = spacetime.lapse_squared(camera.r), radius = spacetime.areal_radius(camera.r);
    const long double w = std::sqrt(static_cast<long double>(std::fmax(1 - lapse2, 0))),
                      s = std::sqrt(static_cast<long double>(std::fmax(lapse2, 0)));
    for (auto& row : tetrad) {
        const long double v = row[0], r = row[1];
        if (from_rain)
            row[0] = v - r / (1 + w), row[1] = w * v + r / (1 + w);
        else
            row[0] = s * v - r / s, row[1] = r / s;
        row[2] *= radius, row[3] *= radius;
    }
    return tetrad;
}

bool in_rain_frame(const Spacetime& spacetime, const CameraSpec& camera) {
    return falls(camera) && spacetime.lapse_squared(camera.r) <= 1;
}

// In the equatorial plane from the azimuth 0, towards growing azimuths: it meets that plane nowhere.
Result<RayPtr> reduced_ray(const OrbitMetric& metric, const ReducedRay& ray, const RayTask& task) {
    if (!(ray.q > 0)) return bad_input(fmt::format("q = {} must be positive (infinite for a radial ray)", ray.q));
    const bool by_length = metric.by_proper_length();
    if (by_length && !(std::abs(ray.zeta0) <= kLargestRadius))
        return bad_input(fmt::format("l0 = {} must lie in [{}, {}]", ray.zeta0, -kLargestRadius, kLargestRadius));
    if (!by_length && !(ray.zeta0 >= 1 / kLargestRadius && ray.zeta0 <= 1 / kLeastRadius))
        return bad_input(
            fmt::format("zeta0 = {} must lie in [{}, {}]", ray.zeta0, 1 / kLargestRadius, 1 / kLeastRadius));
    if (ray.s != 1 && ray.s != -1) return bad_input(fmt::format("s = {} must be 1 (towards the hole) or -1", ray.s));
    TRY(orbit, metric.from_reduced(ray));
    const double r = by_length ? ray.zeta0 : 1 / ray.zeta0, lapse = metric.lapse(r),
                 g = lapse > 0 ? 1 / lapse : kNotANumber, l = 1 / ray.q;
    return RayPtr(std::make_unique<PlaneRay>(metric, std::move(*orbit),
                                             RayPlane(M_PI / 2, 0, {0, 0, 1}, task.plane.normal),
                                             PlanePhoton{r, ray.q, l, -l, Shift{g, 1}, g, false}, task));
}

}  // namespace

double OrbitMetric::lapse2_slope(double r) const {
    double h = std::min(0.01 * r, 0.1 * (r - horizon_radius().value_or(0.0)));  // all of it outside
    while (h > 1e-12 * r && !std::isfinite(lapse(r - 4 * h))) h /= 2;           // of a star
    const auto d = [&](int n) { return lapse2(r + n * h) - lapse2(r - n * h); };
    return (d(1) * 4.0 / 5 - d(2) / 5 + d(3) * 4.0 / 105 - d(4) / 280) / h;
}

std::vector<PlaneCrossing> PlaneRay::crossings(int most, double inner, double outer) const {
    std::vector<PlaneCrossing> list;
    std::optional<LightClock> clock;
    const std::vector<double> warped = task_.shape != nullptr && most > 0
                                           ? warped_crossings(*this, *task_.shape, task_.crossings)
                                           : std::vector<double>();
    for (int k = 1; static_cast<int>(list.size()) < most; ++k) {
        if (task_.shape != nullptr && k > static_cast<int>(warped.size())) break;
        const double angle = task_.shape != nullptr ? warped[static_cast<std::size_t>(k - 1)] : plane_.crossing(k);
        if (!(angle < end())) break;
        const double r = radius_at(angle);
        if (!(r >= inner && r <= outer)) continue;
        // Traced inward is really moving outward.
        const bool outward = 1 / r > orbit_->zeta_at(angle * (1 - 1e-6));
        const double cosine2 = 1 - metric_.lapse2(r) * (photon_.l * photon_.l) / (r * r);
        const double phi = plane_.azimuth(angle);
        PlaneCrossing crossing{
            angle, r,  phi, std::sqrt(std::max(cosine2, 0.0)) * (outward ? 1 : -1), crossing_delay(angle, clock),
            l_z,   phi};
        if (task_.leans() || task_.shape != nullptr) {  // the photon comes against the ray
            const DiscPlane plane = task_.shape != nullptr ? task_.shape->plane(r) : task_.plane;
            const Vec3 at = plane_.direction(angle);
            crossing.l = -photon_.l * dot(plane_.axis(), plane.normal);
            crossing.bearing = std::atan2(dot(at, plane.y), dot(at, plane.x));
        }
        list.push_back(crossing);
    }
    return list;
}

double PlaneRay::crossing_delay(double angle, std::optional<LightClock>& clock) const {
    if (!task_.delays_disc) return 0;
    if (times_ != nullptr)
        if (const auto known = (*times_)(photon_.inward, angle)) return *known;
    if (!clock) clock.emplace(this->clock());
    return clock->delay(angle);
}

std::optional<BodyHit> PlaneRay::first_hit() const {
    std::optional<BodyHit> first;
    if (!task_.bodies || task_.bodies->empty()) return first;
    const bool by_length = metric_.by_proper_length();
    OrbitPlaces places(*orbit_, by_length);
    std::optional<LightClock> clock;
    if (task_.delays_bodies && task_.bodies->move() && !by_length) clock.emplace(this->clock());
    for (const BodyPart& part : task_.bodies->parts()) {
        const auto time_at = [&](double angle) {
            return part.moves && clock ? task_.bodies->time() - clock->delay(angle) : task_.bodies->time();
        };
        const auto angle = by_length ? entry_by_length(*this, part, task_.bodies->time(), places)
                                     : entry(*this, part, time_at, places);
        if (!angle || (first && first->along <= *angle)) continue;
        const Vec3 place = place_at(*angle);
        const bool late = part.turn_rate != 0 && clock;
        const double turn = 1e-6, t = late ? task_.bodies->time() - clock->delay(*angle) : time_at(*angle);
        const Vec3 earlier = place_at(*angle > turn ? *angle - turn : 0);
        const Vec3 normal = part.normal(place, t);
        first = BodyHit{*angle,
                        place,
                        part.number,
                        part.body,
                        normal,
                        cosine_between(normal, earlier - place),
                        part.middle ? part.middle(t) : Vec3{0, 0, 0}};
        const double aside = std::min(turn, 1e-4 * *angle), beyond = *angle + aside < end() ? aside : 0;
        first->toward = place_at(*angle - aside) - place_at(*angle + beyond);
        part.tell(*first, t);
    }
    return first;
}

namespace {

// By the swept angle, of which the affine parameter is r^2/L.
class SweptWay final : public Medium::Way {
public:
    SweptWay(const PlaneRay& ray, double energy) : ray_(ray), unit_(1 / (ray.photon().l * energy)) {}
    Medium::Place at(double along) const override { return {ray_.radius_at(along), ray_.plane().direction(along)}; }
    double affine(const Medium::Place& place, double width) const override { return place.r * place.r * width * unit_; }

private:
    const PlaneRay& ray_;
    double unit_;
};

// Along the radius it is r/E; `along` is how far that has changed.
class RadialWay final : public Medium::Way {
public:
    RadialWay(const PlaneRay& ray, double energy, double sense)
        : direction_(ray.plane().direction(0)), r0_(std::abs(ray.photon().r)), sense_(sense), energy_(energy) {}
    double r(double along) const { return r0_ + sense_ * along; }
    Medium::Place at(double along) const override {
        return {std::abs(r(along)), r(along) < 0 ? -direction_ : direction_};
    }
    double affine(const Medium::Place&, double width) const override { return width / energy_; }

private:
    Vec3 direction_;
    double r0_, sense_, energy_;
};

}  // namespace

std::vector<MediumNode> PlaneRay::medium_nodes() const {
    constexpr double kRadial = 1e-10;  // of L/E, r_s, below which the angle is of no use
    constexpr double kBeforeEnd = 1e-12;
    std::vector<MediumNode> nodes;
    if (task_.medium == nullptr) return nodes;
    const Medium& medium = *task_.medium;
    const double energy = 1 / (photon_.shift.gravity * photon_.shift.doppler), r0 = std::abs(photon_.r);
    if (photon_.l < kRadial) {
        const bool inward = fate() == Fate::kCaptured || !(end() < 1);
        const double least = metric_.horizon_radius().value_or(-medium.farthest()),
                     most = std::max(medium.farthest(), r0);
        const RadialWay way(*this, energy, inward ? -1 : 1);
        medium.add_nodes(0, inward ? r0 - least : most - r0, way, nodes);
        for (MediumNode& node : nodes) node.along = way.r(node.along) < 0 ? M_PI : 0;  // as an angle
        return nodes;
    }
    medium.add_nodes(0, end() * (1 - kBeforeEnd), SweptWay(*this, energy), nodes);
    if (!medium.moves()) return nodes;
    LightClock light = clock();  // it goes on from node to node
    for (MediumNode& node : nodes) node.delay = light.delay(node.along);
    return nodes;
}

double PlaneRay::delay(double along) const { return metric_.by_proper_length() ? kNotANumber : clock().delay(along); }

Result<RayPtr> OrbitMetric::ray(const RayQuery& query, const RayTask& task) const {
    if (query.orbit) return reduced_ray(*this, *query.orbit, task);
    const double least = by_proper_length() ? -kLargestRadius : kLeastRadius;
    if (!(query.r >= least && query.r <= kLargestRadius))
        return bad_input(fmt::format("r = {} must lie in [{}, {}]", query.r, least, kLargestRadius));
    if (!(query.theta >= 0 && query.theta <= M_PI))
        return bad_input(fmt::format("theta = {} must lie in [0, pi]", query.theta));
    if (!std::isfinite(query.phi)) return bad_input("phi must be finite");
    const Vec3 n = query.n;
    const LocalRay local{query.r, n.x, std::hypot(n.y, n.z)};
    const bool rain = query.frame == LocalFrame::kRain;
    if (!rain && horizon_radius() && !(query.r > *horizon_radius()))
        return bad_input(
            fmt::format("no static frame at r = {}: it needs r > {}, the horizon (use frame = rain inside)", query.r,
                        *horizon_radius()));
    RainOrbit start = rain ? from_rain(local) : RainOrbit{from_static(local), 1 / lapse(query.r)};
    // The photon moves against n: L over E is -g r n_phi about the camera's place, and on to the axis.
    const double scale = start.g * query.r, l = scale * local.n_t, l_z = -scale * n.z * std::sin(query.theta);
    return RayPtr(std::make_unique<PlaneRay>(
        *this, std::move(start.orbit), RayPlane(query.theta, query.phi, n, task.plane.normal),
        PlanePhoton{query.r, 1 / l, l, l_z, Shift{start.g, 1}, start.g, rain}, task));
}

Result<std::unique_ptr<RayFamily>> OrbitMetric::rays(const Scene& scene, const Spacetime& spacetime,
                                                     const RayTask& task) const {
    TRY(moving, local_tetrad(spacetime, scene.camera, in_rain_frame(spacetime, scene.camera)));
    Tetrad seen = *moving;
    if (!scene.light.aberration) {
        CameraSpec still = scene.camera;
        still.velocity = {0, 0, 0};
        still.observer = ObserverKind::kStatic;
        TRY(at_rest, local_tetrad(spacetime, still, false));
        seen = *at_rest;
    }
    return std::unique_ptr<RayFamily>(std::make_unique<PlaneRays>(*this, scene, spacetime, task, seen, *moving));
}

PlaneRays::PlaneRays(const OrbitMetric& metric, const Scene& scene, const Spacetime& spacetime, const RayTask& task,
                     const Tetrad& seen, const Tetrad& moving)
    : RayFamily(seen),
      flat_(scene.light.lensing ? nullptr : make_minkowski_orbits({})),
      metric_(flat_ ? *flat_ : metric),
      camera_(scene.camera),
      light_(scene.light),
      task_(task),
      lapse_(metric.lapse(scene.camera.r)),
      from_rain_(in_rain_frame(spacetime, scene.camera)),
      velocity_(moving.front()) {
    if (flat_) camera_.r = spacetime.areal_radius(camera_.r);
    if (!task.many || !task.delays_disc || metric_.by_proper_length() ||
        !(camera_.r > metric_.horizon_radius().value_or(0.0)))
        return;
    const auto ray_at = [this](double inward) {
        const LocalRay local{camera_.r, -std::cos(inward), std::sin(inward)};
        RainOrbit start = start_of(local);
        return LightTimes::Ray{std::move(start.orbit), 1 / (camera_.r * start.g * local.n_t)};
    };
    times_ = std::make_unique<LightTimes>(metric_, ray_at, camera_.r, falls(camera_));
}

RainOrbit PlaneRays::start_of(const LocalRay& local) const {
    return from_rain_ ? metric_.from_rain(local)
                      : RainOrbit{metric_.from_static(local), 1 / (light_.lensing ? lapse_ : 1)};
}

PlaneRays::View PlaneRays::view_of(const Photon& p) const {
    // The photon is null: its frequency in the local frame is the length of its spatial part.
    const long double across = std::sqrt(p[2] * p[2] + p[3] * p[3]),
                      frequency = std::sqrt(p[1] * p[1] + across * across);
    const LocalRay local{camera_.r, static_cast<double>(-p[1] / frequency), static_cast<double>(across / frequency)};
    return {local,
            {local.n_r, static_cast<double>(-p[2] / frequency), static_cast<double>(-p[3] / frequency)},
            across,
            frequency};
}

RayPtr PlaneRays::trace(const Photon& p) const {
    const auto [local, direction, across, frequency] = view_of(p);
    RainOrbit start = start_of(local);
    // The photon moves along p: L_phi = r p^phi in the local tetrad, L_z = L_phi sin(theta), over E = frequency/start.g.
    const double scale = camera_.r * start.g / static_cast<double>(frequency);
    // The camera's frequency over the local frame's is 1/frequency; without aberration that of its true motion.
    const auto& u = velocity_;
    const long double doppler =
        light_.aberration ? 1 / frequency : (u[0] * frequency - u[1] * p[1] - u[2] * p[2] - u[3] * p[3]) / frequency;
    // Where nobody is at rest there are no two parts: all of g counts as motion's.
    const double rest = lapse_ > 0 ? lapse_ : 1;
    const Shift shift = from_rain_ ? Shift{1 / rest, static_cast<double>(doppler) * start.g * rest}
                                   : Shift{1 / lapse_, static_cast<double>(doppler)};
    const double l_phi = scale * static_cast<double>(p[3]), l = scale * static_cast<double>(across);
    return std::make_unique<PlaneRay>(
        metric_, std::move(start.orbit), RayPlane(camera_.theta, camera_.phi, direction, task_.plane.normal),
        PlanePhoton{camera_.r, 1 / std::abs(l), l, l_phi * std::sin(camera_.theta), shift, shift.seen(light_),
                    falls(camera_), std::atan2(local.n_t, -local.n_r)},
        task_, times_.get());
}

std::unique_ptr<Orbit> PlaneRays::orbit_of(Vec3 view) const {
    const LocalRay local{camera_.r, view.x, std::hypot(view.y, view.z)};
    return from_rain_ ? metric_.from_rain(local).orbit : metric_.from_static(local);
}

std::optional<std::array<double, 2>> PlaneRays::position(Vec3 view) const {
    // The photon p = (1, -view) in the local tetrad is omega (e_0 - n^i e_i): n_i = (p . e_i) / (p . e_0).
    const auto product = [&](std::size_t i) {
        const auto& e = tetrad()[i];
        return -e[0] - view.x * e[1] - view.y * e[2] - view.z * e[3];
    };
    const long double ahead = -product(3) / product(0);  // the third axis points backward
    if (!projection_of(camera_).flat || !camera_.warp.empty())
        return pixel_of(camera_, {static_cast<double>(product(1) / product(0)),
                                  static_cast<double>(product(2) / product(0)), static_cast<double>(-ahead)});
    if (!(ahead > 0)) return std::nullopt;
    const long double pixel = camera_.pixel();
    const long double x = product(1) / product(0) / (ahead * pixel * camera_.pixel_aspect),
                      y = product(2) / product(0) / (ahead * pixel);
    const auto [middle_x, middle_y] = line_of_sight(camera_);
    return std::array{middle_x + static_cast<double>(x), middle_y - static_cast<double>(y)};
}

}  // namespace nullscope::reference
