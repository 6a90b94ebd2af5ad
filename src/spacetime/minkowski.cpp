#include "spacetime/minkowski.h"

#include <cstdio>
#include <cstdlib>

namespace nullscope {
namespace {

[[noreturn]] void no_chi(const char* function, double argument) {
    std::fprintf(stderr, "Minkowski::%s(%.17g): there is no photon sphere, hence no angle chi\n", function, argument);
    std::abort();
}

}  // namespace

double Minkowski::chi_from_radius(double r) const { no_chi("chi_from_radius", r); }
double Minkowski::radius_from_chi(double chi) const { no_chi("radius_from_chi", chi); }
double Minkowski::bending_density(double chi) const { no_chi("bending_density", chi); }

std::unique_ptr<Spacetime> make_minkowski(const std::map<std::string, double>&) {
    return std::make_unique<Minkowski>();
}

}  // namespace nullscope
