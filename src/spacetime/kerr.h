// Kerr (1963): a rotating black hole. Horizons: r_+- = (1 +- sqrt(1 - spin^2))/2, the zeros of Delta = r^2 - r + a^2.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "spacetime/axial_metric.h"

namespace nullscope {

class Kerr final : public AxialMetric {
public:
    explicit Kerr(double spin_over_mass) : AxialMetric(spin_over_mass, 0.0) {}  // (0, 1)
    std::string_view name() const override { return "kerr"; }
};

// spin = 0 makes the Schwarzschild metric, with its table.
std::unique_ptr<Spacetime> make_kerr(const std::map<std::string, double>& parameters);

}  // namespace nullscope
