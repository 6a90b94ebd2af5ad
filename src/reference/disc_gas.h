// Turbulent gas of a disc, unfiltered: the law of docs/light.md.
#pragma once
#include <functional>

#include "scene/scene.h"

namespace nullscope::reference {

// Of mean 1: factors on the disc's light and on what shines through it.
struct GasFactors {
    double light = 1, gaps = 1;
};

// At radius r (r_s) and azimuth of the disc, time t (r_s/c). whole: of its opacity, [0, 1], less than 1 within soft rims. rate: angular
// velocity of circular orbits; none: the gas stands still. sense: of them, 1 or -1, which filaments trail.
GasFactors gas_at(const DiscSpec& disc, double r, double azimuth, double t, double whole,
                  const std::function<double(double r)>& rate, double sense = 1);

}  // namespace nullscope::reference
