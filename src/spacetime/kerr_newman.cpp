#include "spacetime/kerr_newman.h"

#include <fmt/format.h>

#include "spacetime/reissner_nordstrom.h"

namespace nullscope {

std::unique_ptr<Spacetime> make_kerr_newman(const std::map<std::string, double>& parameters) {
    const double spin = parameters.at("spin");
    if (spin == 0.0) return make_reissner_nordstrom(parameters);
    return std::make_unique<KerrNewman>(spin, parameters.at("charge"));
}

std::optional<std::string> kerr_newman_fault(const std::map<std::string, double>& parameters) {
    const double spin = parameters.at("spin"), charge = parameters.at("charge");
    if (spin * spin + charge * charge <= KerrNewman::kMost) return std::nullopt;
    return fmt::format(
        "spin = {} with charge = {}: there is no horizon, or next to none; allowed: spin^2 + charge^2 <= {}", spin,
        charge, KerrNewman::kMost);
}

}  // namespace nullscope
