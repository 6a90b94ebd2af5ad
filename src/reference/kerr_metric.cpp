// A rotating hole: its rays are integrated (kerr_ray.h), and no camera and no matter is at rest by itself.
#include <cmath>

#include <fmt/format.h>

#include "observer/observer.h"
#include "reference/kerr_bodies.h"
#include "reference/kerr_chart.h"
#include "reference/kerr_ray.h"
#include "reference/leaning_watch.h"
#include "reference/medium.h"
#include "reference/metric.h"
#include "reference/plane_metrics.h"

namespace nullscope::reference {
namespace {

class TracedKerrRay final : public TracedRay {
public:
    TracedKerrRay(KerrRay ray, const std::optional<BodyHit>& hit, std::vector<MediumNode> nodes, bool delay)
        : TracedRay({1, 1 / ray.energy}, 1 / ray.energy, ray.l_z),
          ray_(std::move(ray)),
          hit_(hit),
          nodes_(std::move(nodes)),
          delays_(delay) {}
    Fate fate() const override { return ray_.fate; }
    double end() const override { return kNotANumber; }
    Vec3 end_direction() const override { return ray_.sky; }
    double end_azimuth() const override { return ray_.phi_inf; }
    double swept(double) const override { return kNotANumber; }
    double delay() const override { return ray_.fate == Fate::kEscaped ? ray_.delay : kNotANumber; }
    std::vector<PlaneCrossing> crossings(int most, double inner, double outer) const override {
        std::vector<PlaneCrossing> list;
        for (const PlaneCrossing& c : ray_.crossings)
            if (c.r >= inner && c.r <= outer && static_cast<int>(list.size()) < most)
                list.push_back(c), list.back().delay = delays_ ? c.delay : 0.0;
        return list;
    }
    std::optional<BodyHit> first_hit() const override { return hit_; }
    std::vector<MediumNode> medium_nodes() const override { return nodes_; }
    double delay(double along) const override {
        if (hit_ && hit_->along == along) return hit_->delay;
        for (const PlaneCrossing& c : ray_.crossings)
            if (c.along == along) return c.delay;
        return kNotANumber;
    }

private:
    KerrRay ray_;
    std::optional<BodyHit> hit_;
    std::vector<MediumNode> nodes_;
    bool delays_;  // of crossings
};

// A step is looked along by its interpolant.
class StepWay final : public Medium::Way {
public:
    StepWay(const KerrHole& hole, const KerrStep& step, bool timed) : hole_(hole), step_(step), timed_(timed) {}
    Medium::Place at(double along) const override {
        if (along == step_.from) return of(step_.begin);
        if (along == step_.to) return of(step_.end);
        const KerrGlance there = step_.glance(along, timed_);
        Medium::Place place{there.r, there.direction, there.delay};
        const double affine_rate = affine(place, 1);
        place.slopes = Medium::Slopes{there.r_slope / affine_rate, there.theta_slope / affine_rate};
        return place;
    }
    double affine(const Medium::Place& place, double width) const override {
        const double x = kerr_distance(hole_, place.r, std::hypot(place.direction.x, place.direction.y));
        return width * x * x;
    }

private:
    static Medium::Place of(const KerrPlace& place) { return {place.r, place.flat() / place.r, place.delay}; }
    const KerrHole& hole_;
    const KerrStep& step_;
    bool timed_;
};

// Crossings that the tracer finds by itself, in its own coordinates.
int equatorial(const RayTask& task) { return task.leans() ? 0 : task.crossings; }

// What looks along the steps of one ray: for the bodies that end it, and for the matter on its way.
class Watches {
public:
    Watches(const KerrHole& hole, const RayTask& task)
        : bodies_(*task.bodies, task.delays_bodies), plane_(hole, task.plane, task.crossings), task_(task) {
        watch = bodies_.watch();
        if (task.leans() && task.crossings > 0)
            watch = [this, meets = std::move(watch)](const KerrStep& step) {
                if (meets) meets(step);
                plane_.see(step);
            };
        if (task.medium == nullptr) return;
        watch = [this, hole, meets = std::move(watch)](const KerrStep& step) {
            if (meets) meets(step);
            if (step.nearest > task_.medium->farthest()) return;
            task_.medium->add_nodes(step.from, step.to, StepWay(hole, step, task_.medium->moves()), nodes_);
        };
    }
    Watches(const Watches&) = delete;
    Watches& operator=(const Watches&) = delete;
    KerrWatch watch;  // while this lives; empty where there is nothing to look for
    RayPtr ray(KerrRay traced) {
        if (task_.leans()) traced.crossings = plane_.crossings(traced);
        return std::make_unique<TracedKerrRay>(std::move(traced), bodies_.hit(), std::move(nodes_), task_.delays_disc);
    }

private:
    BodyWatch bodies_;
    LeaningWatch plane_;
    std::vector<MediumNode> nodes_;
    const RayTask& task_;
};

// A step as a part of a curve; energy: of a photon of unit frequency in the camera.
void show_stretch(const KerrHole& hole, const KerrStep& step, double energy, const StretchWatch& watch) {
    watch({step.from, step.to, step.to - step.from,
           [&](double along) {
               const KerrMotion by = step.motion(along);
               const KerrPlace& at = by.place;
               const double sine = std::sin(at.theta), x = kerr_distance(hole, at.r, sine);
               const double turn = x * x * std::hypot(by.theta, sine * by.phi);
               const double sigma = at.r * at.r + std::pow(hole.a * std::cos(at.theta), 2);
               return StretchPlace{at.r, at.theta, at.phi, x, 1, energy * x * x, turn, -at.delay, 0, sigma};
           },
           [&](double along) {
               const KerrMotion by = step.motion(along);
               return StretchMotion{by.r / energy, by.theta / energy, by.phi / energy, by.t / energy};
           }});
}

class KerrRays final : public RayFamily {
public:
    KerrRays(const KerrHole& hole, const CameraSpec& camera, const Tetrad& tetrad, const RayTask& task)
        : RayFamily(tetrad),
          hole_(hole),
          camera_(camera),
          azimuth_(camera.phi + (falls(camera) ? 0 : kerr_azimuth_ahead(hole, camera.r))),
          task_(task) {}

private:
    KerrPhoton photon(const Photon& p) const { return {camera_.r, camera_.theta, azimuth_, p}; }
    RayPtr trace(const Photon& p) const override {
        Watches watches(hole_, task_);
        return watches.ray(trace_kerr(hole_, photon(p), equatorial(task_), falls(camera_), watches.watch));
    }
    void stretch_along(const Photon& p, double energy, const StretchWatch& watch) const override {
        trace_kerr(hole_, photon(p), 0, falls(camera_),
                   [&](const KerrStep& step) { show_stretch(hole_, step, energy, watch); });
    }
    std::vector<RayPtr> trace_all(const std::vector<Photon>& all) const override {
        std::vector<KerrPhoton> photons;
        std::vector<KerrWatch> watches;
        std::vector<std::unique_ptr<Watches>> rays;
        for (const Photon& p : all) {
            photons.push_back(photon(p));
            watches.push_back(rays.emplace_back(std::make_unique<Watches>(hole_, task_))->watch);
        }
        std::vector<KerrRay> traced = trace_kerr(hole_, photons, equatorial(task_), falls(camera_), watches);
        std::vector<RayPtr> found;
        for (std::size_t i = 0; i < traced.size(); ++i) found.push_back(rays[i]->ray(std::move(traced[i])));
        return found;
    }
    KerrHole hole_;
    CameraSpec camera_;
    double azimuth_;  // of ingoing coordinates
    RayTask task_;
};

class KerrMetric final : public Metric {
public:
    explicit KerrMetric(const KerrHole& hole) : hole_(hole) {}
    std::optional<double> horizon_radius() const override { return hole_.outer(); }
    double a() const override { return hole_.a; }
    bool turns_westward() const override { return hole_.a < 0; }
    EquatorialMetric equator(double r) const override {
        const double a = hole_.a, mass = hole_.twice_mass(r);
        return {-(1 - mass / r), -a * mass / r, hole_.g_phiphi(r), r * r / (r * r - mass * r + a * a)};
    }
    PlaceMetric place(double r, double sine, double cosine) const override {
        const double a = hole_.a, sine2 = sine * sine, cosine2 = cosine * cosine, sigma = r * r + a * a * cosine2,
                     pull = hole_.twice_mass(r) * r / sigma;
        return {pull - 1, -a * pull * sine2, (r * r + a * a + a * a * pull * sine2) * sine2,
                sigma / (r * r - hole_.twice_mass(r) * r + a * a), sigma};
    }
    double within_last_circle() const override { return 1.001 * *horizon_radius(); }
    double rest_lapse(double) const override { return 1; }

    // Along d_v, d_r, d_theta, d_phi/sin(theta) of ingoing coordinates.
    Result<std::unique_ptr<RayFamily>> rays(const Scene& scene, const Spacetime& spacetime,
                                            const RayTask& task) const override {
        TRY(pair, ingoing_hat_pair(spacetime, scene.camera));
        return std::unique_ptr<RayFamily>(std::make_unique<KerrRays>(hole_, scene.camera, long_tetrad(*pair), task));
    }
    Result<RayPtr> ray(const RayQuery& query, const RayTask& task) const override {
        if (query.orbit)
            return bad_input("no ray of a rotating hole is given by q, zeta0 and s",
                             "r, theta, phi, n_r, n_theta, n_phi");
        if (query.frame == LocalFrame::kRain) return bad_input("no frame = rain about a rotating hole", "static");
        const double horizon = *horizon_radius();
        if (!(query.r > horizon && query.r <= kLargestRadius))
            return bad_input(
                fmt::format("r = {} must lie in ({}, {}], outside the horizon", query.r, horizon, kLargestRadius));
        if (!(query.theta >= 0 && query.theta <= M_PI && std::isfinite(query.phi)))
            return bad_input(
                fmt::format("theta = {} must lie in [0, pi] and phi = {} be finite", query.theta, query.phi));
        Watches watches(hole_, task);
        return watches.ray(
            trace_kerr(hole_, KerrStart{query.r, query.theta, query.phi, query.n}, equatorial(task), watches.watch));
    }
    void stretches(const RayQuery& query, double energy, const StretchWatch& watch) const override {
        trace_kerr(hole_, KerrStart{query.r, query.theta, query.phi, query.n}, 0,
                   [&](const KerrStep& step) { show_stretch(hole_, step, energy, watch); });
    }

private:
    KerrHole hole_;
};

}  // namespace

std::unique_ptr<Metric> make_kerr_metric(const SpacetimeSpec& spec) {
    const double spin = parameter_of(spec, "spin", 0.9);
    if (spin == 0) return make_schwarzschild_orbits(spec);
    return std::make_unique<KerrMetric>(KerrHole(spin));
}

std::unique_ptr<Metric> make_kerr_newman_metric(const SpacetimeSpec& spec) {
    const double spin = parameter_of(spec, "spin", 0.6), charge = parameter_of(spec, "charge", 0.6);
    if (spin != 0) return std::make_unique<KerrMetric>(KerrHole(spin, charge));
    return make_reissner_nordstrom_orbits({"reissner-nordstrom", {{"charge", charge}}});
}

}  // namespace nullscope::reference
