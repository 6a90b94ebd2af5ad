#include "annotate/metric_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "spacetime/registry.h"

namespace nullscope {
namespace {

// As the field writes a parameter; `always`: beside another metric too.
struct ParameterWords {
    std::string_view metric, name, words;
    bool always;
};
constexpr std::array kParameters = {
    ParameterWords{"reissner-nordstrom", "charge", "Q = {} M", true},
    ParameterWords{"kerr", "spin", "a = {} M", true},
    ParameterWords{"kerr-newman", "spin", "a = {} M", true},
    ParameterWords{"kerr-newman", "charge", "Q = {} M", true},
    ParameterWords{"neutron-star", "radius", "R = {} rₛ", true},
    ParameterWords{"janis-newman-winicour", "gamma", "γ = {}", true},
    ParameterWords{"ellis", "throat", "throat {}", false},
    ParameterWords{"dneg-wormhole", "throat", "throat {}", false},
    ParameterWords{"dneg-wormhole", "length", "length {}", false},
    ParameterWords{"dneg-wormhole", "lensing_width", "lensing width {}", false},
};

struct MetricTitle {
    std::string_view metric, title;
};
constexpr std::array kTitles = {
    MetricTitle{"schwarzschild", "Schwarzschild"},
    MetricTitle{"reissner-nordstrom", "Reissner–Nordström"},
    MetricTitle{"kerr", "Kerr"},
    MetricTitle{"kerr-newman", "Kerr–Newman"},
    MetricTitle{"neutron-star", "Neutron star"},
    MetricTitle{"ellis", "Ellis wormhole"},
    MetricTitle{"dneg-wormhole", "Wormhole"},
    MetricTitle{"janis-newman-winicour", "Janis–Newman–Winicour"},
    MetricTitle{"minkowski", "Flat spacetime"},
};

std::optional<double> value_of(const SpacetimeSpec& spec, const std::string& name) {
    if (const auto given = spec.parameters.find(name); given != spec.parameters.end()) return given->second;
    const MetricEntry* entry = find_metric(spec.metric);
    if (entry == nullptr) return std::nullopt;
    for (const MetricParameter& parameter : entry->parameters)
        if (parameter.name == name) return parameter.fallback;
    return std::nullopt;
}

std::string title_of(const std::string& metric) {
    for (const MetricTitle& each : kTitles)
        if (each.metric == metric) return std::string(each.title);
    std::string title = metric;  // "dilaton-hole": "Dilaton hole"
    std::replace(title.begin(), title.end(), '-', ' ');
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

// A formula metric's own words are its formulas.
std::string formulas_of(const SpacetimeSpec& spec) {
    std::string words;
    for (const auto& [name, text] : spec.parameters.formulas)
        words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", name, text);
    return words;
}

}  // namespace

std::string metric_words(const SpacetimeSpec& spec, const SpacetimeSpec& other) {
    if (!spec.parameters.formulas.empty()) return formulas_of(spec);
    std::string words = title_of(spec.metric);
    const MetricEntry* entry = find_metric(spec.metric);
    if (entry == nullptr) return words;
    const bool same = spec.metric == other.metric;
    for (const MetricParameter& parameter : entry->parameters) {
        const std::string name(parameter.name);
        const auto known = std::find_if(kParameters.begin(), kParameters.end(), [&](const ParameterWords& each) {
            return each.metric == spec.metric && each.name == name;
        });
        const bool shown = same                         ? value_of(spec, name) != value_of(other, name)
                           : known == kParameters.end() ? spec.parameters.contains(name)
                                                        : known->always;
        if (!shown) continue;
        const std::string number = fmt::format("{:g}", value_of(spec, name).value_or(0.0));
        words += ", ";
        words += known == kParameters.end() ? fmt::format("{} = {}", name, number)
                                            : fmt::format(fmt::runtime(known->words), number);
    }
    return words;
}

}  // namespace nullscope
