#include "viewer/probe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/view_state.h"

namespace nullscope::viewer {
namespace {

constexpr int kPathPoints = 400;
constexpr double kPathReach = 3;  // of the camera's radius

// end: the swept angle where it ends, at what it meets or beyond all.
PotentialRay potential_ray(const reference::PlaneRay& plane, double end, const Scene& scene,
                           const Spacetime& spacetime) {
    const reference::Orbit& orbit = plane.orbit();
    const auto place = [&](double zeta) { return spacetime.by_proper_length() ? zeta : 1 / zeta; };
    PotentialRay ray;
    ray.level = plane.photon().q * plane.photon().q;
    ray.camera = scene.camera.r;
    ray.straight = !scene.light.lensing;
    if (std::isfinite(orbit.turn()) && !(orbit.turn_angle() > end)) ray.turn = place(orbit.turn());
    if (end < plane.end())
        ray.end = place(orbit.zeta_at(end));
    else if (plane.fate() == Fate::kCaptured)
        ray.end = spacetime.horizon_radius();
    else if (plane.fate() == Fate::kHit)
        ray.end = spacetime.surface_radius();
    else if (plane.fate() != Fate::kNoSky)
        ray.end = plane.fate() == Fate::kOtherSide ? -kAnyRadius : kAnyRadius;
    return ray;
}

}  // namespace

// A tracer follows the whole scene; how matter moves, the spacetime and the disc alone.
bool Probe::follow(const Scene& scene) {
    const bool other_matter = !spacetime_ || !(scene.spacetime == scene_.spacetime) || scene.disc != scene_.disc ||
                              !(scene.light == scene_.light);
    auto made = reference::FrameTracer::make(scene);
    const auto spacetime = spacetime_of(scene);
    if (!made || spacetime == nullptr) return false;
    tracer_.emplace(std::move(*made));
    spacetime_ = spacetime;
    if (other_matter) {
        matter_.reset();
        auto metric = reference::make_metric(scene.spacetime);
        if (!metric) return false;
        metric_ = std::move(*metric);
        DiscSpec dark;  // its heat is not asked for
        dark.outer = 0.0;
        if (scene.disc && scene.disc->emission == DiscEmission::kThermal) matter_.emplace(*metric_, dark, scene.light);
    }
    circles_ = landmark_circles(*spacetime_);
    scene_ = scene;
    return true;
}

void Probe::look(const Scene& scene, double x, double y) {
    facts_.reset();
    if (x < 0 || y < 0 || x >= scene.camera.width || y >= scene.camera.height || !follow(scene)) return;
    facts_ = facts_of(*tracer_->ray(x, y), x, y);
}

void Probe::meet_disc(const reference::TracedRay& ray, const reference::DiscHit& hit, ProbeFacts& facts) const {
    facts.hit = kDiscHit;
    facts.hit_r = std::hypot(hit.x, hit.y);
    if (!matter_) return;
    const reference::Shift matter = matter_->shift({facts.hit_r, hit.l, hit.climb, hit.cosine, hit.across});
    facts.shift = reference::Shift{ray.shift.gravity * matter.gravity, ray.shift.doppler * matter.doppler};
}

// Places on the curve of nullscope trace --points, projected; the camera's azimuth, without it of where light begins, is to the right.
void Probe::see_from_pole(double x, double y, double end, double g, ProbeFacts& facts) const {
    const CameraSpec& camera = scene_.camera;
    const reference::CurveSpec spec{kPathPoints, kPathReach * camera.r};
    const auto curve = reference::pixel_curve(*tracer_, *spacetime_, {x, y, camera.r, g, end}, spec);
    if (!curve.empty()) facts.windings = std::fabs(curve.back().phi - curve.front().phi) / (2 * M_PI);
    for (const reference::CurvePoint& point : curve) {
        const double across = point.r * std::sin(point.theta), round = point.phi - curve.front().phi;
        facts.path.push_back({across * std::cos(round), across * std::sin(round), point.r});
    }
}

ProbeFacts Probe::facts_of(const reference::TracedRay& ray, double x, double y) const {
    ProbeFacts facts;
    facts.fate = ray.fate();
    facts.zeta0 = 1 / spacetime_->areal_radius(scene_.camera.r);
    facts.shift = ray.shift;
    const reference::PlaneRay* plane = ray.in_plane();
    double end = plane ? ray.end() : reference::kNowhere;
    const auto hits = tracer_->disc_hits(ray, 1);
    const auto body = ray.first_hit();
    if (!hits.empty() && !(body && body->along < hits.front().along)) {
        meet_disc(ray, hits.front(), facts);
        if (scene_.disc->opacity == 1) end = hits.front().along;
    } else if (body) {
        facts.hit = body->number;
        facts.hit_r = length(body->place);
        end = body->along;
        if (plane) facts.shift->gravity *= plane->metric().lapse(facts.hit_r);  // it rests
    } else if (facts.fate == Fate::kHit) {
        facts.hit = kStarHit;
        facts.shift->gravity *= plane->metric().lapse(plane->radius_at(end * (1 - 1e-12)));
    } else if (facts.fate == Fate::kCaptured) {
        facts.shift.reset();
    } else {
        facts.delay = ray.delay();
    }
    if (!plane) {  // no orbit, no impact parameter
        see_from_pole(x, y, end, ray.g, facts);
        return facts;
    }
    const reference::Orbit& orbit = plane->orbit();
    const auto radius = [&](double zeta) {
        return plane->metric().by_proper_length() ? spacetime_->areal_radius(zeta) : 1 / zeta;
    };
    facts.impact = 1 / std::fabs(plane->photon().q);
    if (const auto sphere = spacetime_->photon_sphere()) facts.of_critical = facts.impact * sphere->q_crit;
    if (std::isfinite(orbit.turn())) facts.turn_r = radius(orbit.turn());
    facts.potential = potential_ray(*plane, end, scene_, *spacetime_);
    if (!std::isfinite(end)) return facts;
    facts.windings = end / (2 * M_PI);
    for (int i = 0; i <= kPathPoints; ++i) {
        const double angle = end * i / kPathPoints, zeta = orbit.zeta_at(std::min(angle, end * (1 - 1e-9))),
                     r = radius(zeta);
        if (std::isfinite(r))
            facts.path.push_back({r * std::cos(angle), r * std::sin(angle), spacetime_->by_proper_length() ? zeta : r});
    }
    if (const double met = plane->plane().crossing(1); met <= end * (1 + 1e-9)) facts.disc = met;
    return facts;
}

}  // namespace nullscope::viewer
