#include "spacetime/ellis.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace nullscope {
namespace {

[[noreturn]] void no_zeta() {
    std::fprintf(stderr, "Ellis: there is no orbit equation in zeta, which is the same on both sides\n");
    std::abort();
}

}  // namespace

double Ellis::areal_radius(double l) const { return std::hypot(l, throat_); }
double Ellis::radius_slope(double l) const { return l / areal_radius(l); }
double Ellis::radius_curvature(double l) const {
    const double radius = areal_radius(l), part = throat_ / radius;
    return part * part / radius;
}
double Ellis::chi_from_radius(double l) const { return std::atan2(throat_, l); }
double Ellis::radius_from_chi(double chi) const { return throat_ * std::cos(chi) / std::sin(chi); }
double Ellis::half_v_slope(double) const { no_zeta(); }
double Ellis::half_v_curvature(double) const { no_zeta(); }

std::unique_ptr<Spacetime> make_ellis(const std::map<std::string, double>& parameters) {
    return std::make_unique<Ellis>(parameters.at("throat"));
}

}  // namespace nullscope
