#include "spacetime/neutron_star.h"

namespace nullscope {

std::unique_ptr<Spacetime> make_neutron_star(const std::map<std::string, double>& parameters) {
    return std::make_unique<NeutronStar>(parameters.at("radius"));
}

}  // namespace nullscope
