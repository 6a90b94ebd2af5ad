// What a test vector's row can be asked for: the condition number of an output of a traced ray.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "reference/reference.h"

namespace nullscope {

using VectorTrace = std::function<Result<RayRecord>(double q, double zeta0, std::optional<double> at)>;
using VectorOutput = std::function<double(const RayRecord&)>;

// Of an output y of the inputs x = (q, zeta0, and the swept angle `at` where one is asked for):
//     kappa = max(1, sum_i |x_i dy/dx_i| / |y|),
// the factor by which a relative change of the inputs comes back as a relative change of y. The derivatives are one-sided
// differences of the traced function, the larger side counts; the step stays below `room`, how far, relatively, the critical ray
// and the turning point are, where y is singular.
inline double condition_number(const VectorTrace& trace, double q, double zeta0, double room,
                               const VectorOutput& output, std::optional<double> at) {
    const auto here = trace(q, zeta0, at);
    const double y = output(*here), step = std::max(1e-5 * std::min(1.0, room), 1e-15);
    double sum = 0;
    for (int input = 0; input < (at ? 3 : 2); ++input) {
        double worst = 0;
        for (const double h : {step, -step}) {
            const auto there = trace(q * (input == 0 ? 1 + h : 1), zeta0 * (input == 1 ? 1 + h : 1),
                                     at ? std::optional(*at * (input == 2 ? 1 + h : 1)) : at);
            if (!there || there->fate != here->fate) continue;
            const double change = std::abs(output(*there) - y) / (step * std::abs(y));
            if (std::isfinite(change)) worst = std::max(worst, change);
        }
        sum += worst;
    }
    return std::max(1.0, sum);
}

}  // namespace nullscope
