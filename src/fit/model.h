// What a fit compares: numbers that were measured, and what a model says they are.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"

namespace nullscope::fit {

inline constexpr std::size_t kMostData = 4'000'000;

struct Observed {
    std::vector<double> value, sigma;  // of each: finite; its standard deviation, above 0
    std::string what;                  // for people: "16384 pixels of data.fits"
};

// A number for each datum, without noise.
using Prediction = std::vector<double>;

class Model {
public:
    virtual ~Model() = default;
    // parameters: in the unit of scene files. Errors: there is no such scene, or it cannot be drawn.
    virtual Result<Prediction> predict(const std::vector<double>& parameters) = 0;
    // Its derivative by each parameter, exact, where the model has it. Errors: why it has none, in a short phrase; the solver takes differences.
    virtual Result<std::vector<Prediction>> derivatives(const std::vector<double>& parameters) {
        (void)parameters;
        return failed("such data have no exact ones");
    }
};

}  // namespace nullscope::fit
