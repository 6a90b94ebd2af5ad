// g = 1/(-p . u) for a photon of unit energy at infinity. By orthonormal components of observers without angular momentum (ZAMO), of
// lapse alpha and rate omega: p = E (1, n), E = (1 - omega L)/alpha, u = gamma (1, w), so -p . u = gamma (E - n . w). L is known, so n_phi is, and n's other
// two components, of which the ray tells the ratio, follow from |n| = E.
#include "reference/body_shift.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {

constexpr double kOffAxis = 1e-12;  // of the polar angle: next to the axis east is a matter of choice

// Axes (e_r, e_theta, e_phi) of a place, as unit vectors of flat coordinates, and what a ZAMO there measures them with.
struct Zamo {
    double r, sine, cosine;
    Vec3 out, south, east;
    PlaceMetric g;
    double alpha, omega;
    explicit Zamo(const Metric& metric, Vec3 x)
        : r(length(x)), sine(std::max(std::hypot(x.x, x.y) / r, kOffAxis)), cosine(x.z / r), out(x / r) {
        const double azimuth = std::atan2(x.y, x.x), c = std::cos(azimuth), s = std::sin(azimuth);
        south = {cosine * c, cosine * s, -sine}, east = {-s, c, 0};
        g = metric.place(r, sine, cosine);
        omega = -g.g_tphi / g.g_phiphi;
        alpha = std::sqrt(std::max(g.g_tphi * g.g_tphi / g.g_phiphi - g.g_tt, 0.0));
    }
    // (r', r theta', r sin(theta) phi') by t -> what is measured.
    Vec3 measured(Vec3 v) const {
        return Vec3{std::sqrt(g.g_rr) * dot(v, out), std::sqrt(g.g_thetatheta) * dot(v, south) / r,
                    std::sqrt(g.g_phiphi) * (dot(v, east) / (r * sine) - omega)} /
               alpha;
    }
    Vec3 flat(Vec3 w) const { return w.x * out + w.y * south + w.z * east; }
    Vec3 local(Vec3 v) const { return {dot(v, out), dot(v, south), dot(v, east)}; }
};

// Where a photon goes that has unit energy at infinity: a unit vector of what the ZAMO measures.
Vec3 way_at(const Zamo& at, const Metric& matter, const TracedRay& ray, Vec3 toward, bool lensing) {
    const Vec3 way = at.local(toward);
    if (matter.orbits() != nullptr)
        return normalized(Vec3{lensing ? std::sqrt(at.g.g_rr) * way.x : way.x, way.y, way.z});
    const double energy = (1 - at.omega * ray.l_z) / at.alpha, east = ray.l_z / std::sqrt(at.g.g_phiphi) / energy,
                 out = std::sqrt(at.g.g_rr) * way.x, south = std::sqrt(at.g.g_thetatheta) * way.y / at.r,
                 rest = std::sqrt(std::max(1 - east * east, 0.0)) / std::max(std::hypot(out, south), 1e-300);
    return {rest * out, rest * south, east};
}

}  // namespace

Vec3 body_velocity(const BodyPart& part, Vec3 place, double t) {
    if (!part.moves) return part.turn_rate * Vec3{-place.y, place.x, 0};
    const double h = 1e-5 * std::max(1.0, 1e-4 * std::abs(t));
    if (part.middle) return (part.middle(t + h) - part.middle(t - h)) / (2 * h);
    const double tiny = 1e-6 * part.thinnest;
    const Vec3 normal = part.normal(place, t);
    const double steep = (part.value(place + tiny * normal, t) - part.value(place - tiny * normal, t)) / (2 * tiny),
                 rate = (part.value(place, t + h) - part.value(place, t - h)) / (2 * h);
    return steep > 0 ? -rate / steep * normal : Vec3{0, 0, 0};
}

Shift body_shift(const Metric& matter, const TracedRay& ray, const BodyHit& hit, bool lensing) {
    const Zamo at(matter, hit.place);
    if (!hit.moves) {
        const double rest = matter.rest_lapse(at.r);
        return {rest, std::sqrt(std::max(-at.g.g_tt, 0.0)) / rest};
    }
    const Zamo from(matter, hit.carries ? hit.middle : hit.place);
    const double rest = matter.rest_lapse(from.r), energy = (1 - from.omega * ray.l_z) / from.alpha;
    const Vec3 w = from.flat(from.measured(hit.velocity)), n = at.flat(way_at(at, matter, ray, hit.toward, lensing));
    const double slow = 1 - dot(w, w), frequency = energy * (1 - dot(n, w));
    if (!(slow > 0) || !(frequency > 0)) return {rest, 0};
    return {rest, std::sqrt(slow) / frequency / rest};
}

}  // namespace nullscope::reference
