// The list of spacetimes: a metric is added by one file pair and one line in registry.cpp.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct MetricParameter {
    std::string_view name;
    double fallback, low, high;  // default and allowed range, inclusive
    std::string_view help;
};
struct MetricEntry {
    std::string_view key;
    std::string_view help;  // one sentence
    std::vector<MetricParameter> parameters;
    std::unique_ptr<Spacetime> (*make)(const std::map<std::string, double>& parameters);
    // What is wrong with parameters that are each within its range, and what is allowed; nullptr: nothing can be.
    std::optional<std::string> (*fault)(const std::map<std::string, double>& parameters) = nullptr;
};

std::span<const MetricEntry> metric_registry();
const MetricEntry* find_metric(std::string_view key);
// Errors: unknown metric (nearest named), unknown parameter, value out of range, values that do not go together.
Result<std::shared_ptr<const Spacetime>> make_spacetime(const std::string& metric,
                                                        const std::map<std::string, double>& parameters);

}  // namespace nullscope
