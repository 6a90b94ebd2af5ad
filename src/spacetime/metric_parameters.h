// The parameters of a metric by name: numbers, which is what nearly all are, and the texts of those that are formulas.
#pragma once
#include <map>
#include <string>
#include <utility>

namespace nullscope {

struct MetricParameters : std::map<std::string, double> {
    using Numbers = std::map<std::string, double>;
    using Numbers::Numbers;
    MetricParameters() = default;
    MetricParameters(Numbers numbers) : Numbers(std::move(numbers)) {}  // a map of numbers is one without formulas
    std::map<std::string, std::string> formulas;
    friend bool operator==(const MetricParameters&, const MetricParameters&) = default;
};

}  // namespace nullscope
