#include "camera/spin_forms.h"

#include <cmath>

namespace nullscope {

SpinForms spin_forms(const Spacetime& spacetime, double r, double theta) {
    const double a = spacetime.spin(), outer = *spacetime.horizon_radius(), sine = std::sin(theta), cosine = std::cos(theta);
    const double delta = (r - outer) * (r - a * a / outer), sigma = r * r + a * a * cosine * cosine, across = r * r + a * a;
    const double root = std::sqrt(delta), v = a * sine * root / across, gamma = 1.0 / std::sqrt((1.0 - v) * (1.0 + v));
    const double stretch = gamma * std::sqrt(sigma);
    SpinForms forms;
    forms.energy = -gamma * root * std::sqrt(sigma) / across;          // minus the lapse
    forms.energy_slope = gamma * a * sine * r / (across * std::sqrt(sigma));   // (1 - Delta/(r^2 + a^2)) = r/(r^2 + a^2)
    forms.carter = stretch * v;
    forms.carter_slope = stretch;
    forms.p_theta = std::sqrt(sigma);
    forms.momentum = std::sqrt(across + a * a * r * sine * sine / sigma);
    forms.zeta_slope = root * std::sqrt(sigma) / (r * r);
    return forms;
}

}  // namespace nullscope
