#include "spacetime/leaning_circle.h"

#include <algorithm>
#include <cmath>

#include "spacetime/axial_metric.h"

namespace nullscope {

std::optional<double> leaning_rate(const Spacetime& spacetime, double r, Sense sense, double tilt) {
    const auto orbit = circular_orbit(spacetime, r, sense);
    if (!orbit) return {};
    if (tilt == 0.0 || !spacetime.rotates() || orbit->omega == 0.0) return orbit->omega;
    const double a = spacetime.a();
    return 1.0 / (1.0 / orbit->omega - a + a * std::cos(tilt));
}

double leaning_lapse2(const Spacetime& spacetime, double r, double rate, double tilt, double sine) {
    const AxialMetric& hole = *spacetime.axial();
    const double a = hole.a(), c = std::cos(tilt), sine2 = std::max(sine * sine, 1e-30),
                 part = std::min(c * c / sine2, 1.0);
    const double sigma = r * r + a * a * (1.0 - sine2), pull = hole.two_mass(r) * r / sigma;
    return 1.0 - pull + 2.0 * a * pull * rate * c -
           rate * rate * (sigma * (1.0 - part) + (r * r + a * a + a * a * pull * sine2) * part);
}

std::optional<double> leaning_disc_limit(const Spacetime& spacetime, double inner, double outer, Sense sense,
                                         double tilt) {
    constexpr int kRadii = 400, kPlaces = 32;
    for (int i = kRadii; i >= 0; --i) {
        const double r = inner * std::pow(outer / inner, static_cast<double>(i) / kRadii);
        const auto rate = leaning_rate(spacetime, r, sense, tilt);
        if (!rate) return r;
        for (int k = 0; k <= kPlaces; ++k) {  // of a quarter of the circle: the others have the same
            const double up = std::sin(tilt) * std::sin(0.5 * M_PI * k / kPlaces);
            if (!(leaning_lapse2(spacetime, r, *rate, tilt, std::sqrt(std::max(1.0 - up * up, 0.0))) > 0.0)) return r;
        }
    }
    return {};
}

}  // namespace nullscope
