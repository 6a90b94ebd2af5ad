#include "reference/kerr_launch.h"

namespace nullscope::reference {
namespace {

constexpr double kOnEquator = 1e-12;  // |cos theta| below which a camera is in the plane (docs/ray-data.md)

// p_r of the chart of the mirror image, with x^2 - y^2 = Delta K, y = climb: (x + y)/Delta - E.
double mirror_p_r(const KerrChart& chart, double r, double sine, const KerrLaunch& l) {
    const double a = chart.a, x = l.energy * (r * r + a * a) - a * l.l_over_sine * sine,
                 w = l.l_over_sine - a * l.energy * sine;
    const double carter = l.p_theta * l.p_theta + w * w;
    return (l.climb < 0 ? carter / (x - l.climb) : (x + l.climb) / chart.delta(r)) - l.energy;
}

}  // namespace

KerrLaunch kerr_launch(const KerrChart& chart, const KerrStart& start) {
    const double a = chart.a, r = start.r, sine = std::sin(start.theta), cosine = std::cos(start.theta);
    const double sigma = r * r + a * a * cosine * cosine, across = r * r + a * a, delta = chart.delta(r);
    const double mass_r = chart.twice_mass(r) * r,
                 area = across * sigma + a * a * mass_r * sine * sine;  // (r^2 + a^2)^2 - Delta a^2 sin^2
    const double lapse = std::sqrt(delta * sigma / area), drag = a * mass_r / area, girth = std::sqrt(area / sigma);
    KerrLaunch l{};
    l.r = r, l.theta = start.theta, l.phi = start.phi, l.falls = false;
    l.l_over_sine = -girth * start.direction.z;  // the photon runs against the view direction
    l.energy = lapse * length(start.direction) + drag * l.l_over_sine * sine;
    l.p_theta = std::sqrt(sigma) * start.direction.y, l.climb = std::sqrt(sigma * delta) * start.direction.x;
    l.p_r = mirror_p_r(chart, r, sine, l);
    return l;
}

// Down with the metric of ingoing coordinates. What is traced outward fell in.
KerrLaunch kerr_launch(const KerrChart& chart, const KerrPhoton& photon) {
    const long double a = chart.a, r = photon.r, sine = std::sin(photon.theta), cosine = std::cos(photon.theta),
                      drag = a * sine;
    const long double sigma = r * r + a * a * cosine * cosine, hole = chart.twice_mass(photon.r) * r / sigma;
    const auto& [v, radial, theta, phi] = photon.p;
    KerrLaunch l{};
    l.r = photon.r, l.theta = photon.theta, l.phi = photon.phi;
    l.energy = static_cast<double>((1 - hole) * v - radial + drag * hole * phi);
    l.l_over_sine = static_cast<double>(-drag * hole * v - drag * radial + (r * r + a * a + drag * drag * hole) * phi);
    l.p_theta = static_cast<double>(-sigma * theta), l.climb = static_cast<double>(-sigma * radial);
    l.falls = l.climb >= 0 || photon.r <= chart.outer();
    if (l.falls) {
        l.p_r = -(static_cast<double>(v - drag * phi) - l.energy);
    } else {
        l.phi -= chart.ahead(photon.r) - std::atan2(chart.a, photon.r);
        l.p_r = mirror_p_r(chart, photon.r, std::sin(photon.theta), l);
    }
    return l;
}

KerrLaunch mirrored(const KerrChart& chart, const KerrPhase& phase, double energy, double phi) {
    const auto& [x, p] = phase;
    const double a = chart.a, r = chart.radius(x), cosine = x.z / r, across = r * r + a * a;
    const double flat = std::hypot(x.x, x.y), sine = flat / std::sqrt(across), sigma = r * r + a * a * cosine * cosine;
    const double co = flat > 0 ? x.x / flat : 1, si = flat > 0 ? x.y / flat : 0, girth = std::sqrt(across);
    KerrLaunch l{};
    l.r = r, l.theta = std::atan2(sine, cosine), l.falls = false, l.energy = energy, l.phi = phi;
    l.p_theta = girth * cosine * (co * p.x + si * p.y) - r * sine * p.z;
    l.l_over_sine = -girth * (co * p.y - si * p.x);
    l.climb = sigma * chart.rising(x, p + chart.pull(-energy, x, p).drift);
    l.p_r = mirror_p_r(chart, r, sine, l);
    return l;
}

// The mirror image has the energy and L_z of the photon, and moves in r and theta towards where that came from. Traced
// backward the photon has the opposite momentum.
KerrBeginning beginning(const KerrChart& chart, const KerrLaunch& launch) {
    const double a = chart.a, r = launch.r, sine = std::sin(launch.theta), cosine = std::cos(launch.theta);
    const double height = std::abs(cosine) < kOnEquator ? 0.0 : cosine, sigma = r * r + a * a * height * height;
    const double psi = launch.falls ? 0 : chart.ahead(r) - std::atan2(a, r), c = std::cos(psi), s = std::sin(psi);
    // Along the unit vectors of the angles theta and psi: the place is (r, 0, a sine), d(place)/dr = (1, 0, 0),
    // d(place)/dtheta = (0, r, a cosine), and what psi moves, over the sine, (-a sine, -a cosine, r). p is known along
    // these three.
    const double around = launch.sense() * launch.l_over_sine + launch.p_r * a * sine;
    const Vec3 p{launch.p_r, (r * launch.p_theta - a * height * around) / sigma,
                 (r * around + a * height * launch.p_theta) / sigma};
    const Vec3 place{r, 0, a * sine}, momentum{-place.z * p.y, place.z * p.x - r * p.z, r * p.y};
    const double far = std::hypot(r, place.z);
    const auto flat = [&](const Vec3& v) {
        const double out = v.x * sine + v.y * height;
        return Vec3{c * out - s * v.z, s * out + c * v.z, v.x * height - v.y * sine};
    };
    return {flat(place / far), flat(momentum), 1 / far, (r / far) * p.x + (place.z / far) * p.z,
            psi + std::atan2(a, r)};
}

}  // namespace nullscope::reference
