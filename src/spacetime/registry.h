// The list of spacetimes: a metric is added by its file or files and one line in registry.cpp.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "spacetime/metric_parameters.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct MetricParameter {
    std::string_view name;
    double fallback, low, high;  // default and allowed range, inclusive
    std::string_view help;
};
// A parameter that is a formula of r (docs/expressions.md).
struct MetricFormula {
    std::string_view name;
    std::string_view fallback;  // what it is where it is not given, as it is written in the documents
    bool needed;                // scene files must give it
    std::string_view help;
};
struct MetricEntry {
    std::string_view key;
    std::string_view help;  // one sentence
    std::vector<MetricParameter> parameters;
    std::unique_ptr<Spacetime> (*make)(const std::map<std::string, double>& parameters);
    // Parameters, each within its range, together; nullptr: all go together. Errors: of the key of one.
    Status (*check)(const std::map<std::string, double>& parameters) = nullptr;
    // Of a metric that has formulas, and then instead of make. Errors: of the key of one.
    std::vector<MetricFormula> formulas = {};
    Result<std::shared_ptr<const Spacetime>> (*make_of_formulas)(const std::map<std::string, std::string>& texts) =
        nullptr;
};

std::span<const MetricEntry> metric_registry();
const MetricEntry* find_metric(std::string_view key);
// Errors: unknown metric (nearest named), unknown parameter, value out of range, values that do not go together.
Result<std::shared_ptr<const Spacetime>> make_spacetime(const std::string& metric, const MetricParameters& parameters);

}  // namespace nullscope
