// Kerr and Newman (1965): a rotating black hole with electric charge, which light feels by the metric alone. Horizons:
// r_+- = (1 +- sqrt(1 - spin^2 - charge^2))/2, the zeros of Delta = r^2 - r + a^2 + (charge/2)^2.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "spacetime/axial_metric.h"

namespace nullscope {

class KerrNewman final : public AxialMetric {
public:
    static constexpr double kMost = 0.9998;  // of spin^2 + charge^2: what spin alone has in kerr
    KerrNewman(double spin_over_mass, double charge_over_mass) : AxialMetric(spin_over_mass, charge_over_mass) {}
    std::string_view name() const override { return "kerr-newman"; }
};

// spin = 0 makes the Reissner-Nordstrom metric, with its table.
std::unique_ptr<Spacetime> make_kerr_newman(const std::map<std::string, double>& parameters);
// What of the two together is wrong, and what is allowed.
std::optional<std::string> kerr_newman_fault(const std::map<std::string, double>& parameters);

}  // namespace nullscope
