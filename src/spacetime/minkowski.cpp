#include "spacetime/minkowski.h"

namespace nullscope {

std::unique_ptr<Spacetime> make_minkowski(const std::map<std::string, double>&) {
    return std::make_unique<Minkowski>();
}

}  // namespace nullscope
