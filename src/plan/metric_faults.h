// What of a scene is not followed in its metric.
#pragma once
#include <vector>

#include "plan/caps.h"
#include "plan/glow.h"
#include "plan/medium.h"
#include "plan/moving.h"
#include "plan/sides.h"

namespace nullscope {

inline std::vector<SceneFault> metric_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults = side_faults(spacetime, scene);
    for (SceneFault& fault : late_fall_faults(spacetime.rotates(), scene)) faults.push_back(std::move(fault));
    for (auto* more : {glow_faults, cap_faults, medium_faults})
        for (SceneFault& fault : more(spacetime, scene)) faults.push_back(std::move(fault));
    return faults;
}

}  // namespace nullscope
