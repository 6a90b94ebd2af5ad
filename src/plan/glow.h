// Bodies that shine by their heat: which metrics can tell how the frequencies of their light arrive.
#pragma once
#include <optional>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

class Spacetime;

// A = 1 - sum/r + product/r^2, A B = 1 and areal r: Schwarzschild's, Reissner and Nordstrom's, neutron stars', flat space.
struct LapseForm {
    double sum, product;
};
// Of a metric whose rays stay in planes; nothing where A is another function. A few values of A, compared to 1e-12.
std::optional<LapseForm> lapse_form(const Spacetime& spacetime);

// Bodies with a temperature in a metric that has no such form and does not rotate.
std::vector<SceneFault> glow_faults(const Spacetime& spacetime, const Scene& scene);
Status check_glow(const Spacetime& spacetime, const Scene& scene);  // the first of them

}  // namespace nullscope
