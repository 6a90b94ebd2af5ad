#include "spacetime/ellis.h"

#include <cmath>

namespace nullscope {
double Ellis::areal_radius(double l) const { return std::hypot(l, throat_); }
double Ellis::radius_slope(double l) const { return l / areal_radius(l); }
double Ellis::radius_curvature(double l) const {
    const double radius = areal_radius(l), part = throat_ / radius;
    return part * part / radius;
}
double Ellis::chi_from_radius(double l) const { return std::atan2(throat_, l); }
double Ellis::radius_from_chi(double chi) const { return throat_ * std::cos(chi) / std::sin(chi); }

std::unique_ptr<Spacetime> make_ellis(const std::map<std::string, double>& parameters) {
    return std::make_unique<Ellis>(parameters.at("throat"));
}

}  // namespace nullscope
