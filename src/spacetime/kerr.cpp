#include "spacetime/kerr.h"

#include "spacetime/schwarzschild.h"

namespace nullscope {

std::unique_ptr<Spacetime> make_kerr(const std::map<std::string, double>& parameters) {
    const double spin = parameters.at("spin");
    if (spin == 0.0) return make_schwarzschild({});
    return std::make_unique<Kerr>(spin);
}

}  // namespace nullscope
