#include "spacetime/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.h"
#include "spacetime/axial_metric.h"
#include "spacetime/dneg_wormhole.h"
#include "spacetime/ellis.h"
#include "spacetime/formula_metric.h"
#include "spacetime/janis_newman_winicour.h"
#include "spacetime/minkowski.h"
#include "spacetime/naked_charge.h"
#include "spacetime/neutron_star.h"
#include "spacetime/reissner_nordstrom.h"
#include "spacetime/schwarzschild.h"

namespace nullscope {
namespace {

using Numbers = std::map<std::string, double>;
using Made = std::unique_ptr<Spacetime>;

Made flat(const Numbers&) { return std::make_unique<Minkowski>(); }
Made plain(const Numbers&) { return std::make_unique<Schwarzschild>(); }
Made charged(const Numbers& of) {
    const double charge = of.at("charge");
    if (charge > 1.0) return std::make_unique<NakedCharge>(charge);
    return std::make_unique<ReissnerNordstrom>(charge);
}

// Without spin the spherical hole, with its table.
Made rotating(const Numbers& of) {
    if (of.at("spin") == 0.0) return plain(of);
    return std::make_unique<AxialMetric>("kerr", of.at("spin"), 0.0);
}
Made rotating_charged(const Numbers& of) {
    if (of.at("spin") == 0.0) return charged(of);
    return std::make_unique<AxialMetric>("kerr-newman", of.at("spin"), of.at("charge"));
}

Status check_rotating_charged(const Numbers& of) {
    const double spin = of.at("spin"), charge = of.at("charge");
    if ((1.0 - spin) * (1.0 + spin) - charge * charge >= -AxialMetric::kRounding) return Done{};
    return bad_key("spin", fmt::format("{} with charge = {}: there is no horizon", spin, charge),
                   "spin^2 + charge^2 <= 1");
}

const MetricParameter* find_parameter(const MetricEntry& entry, std::string_view name) {
    for (const MetricParameter& parameter : entry.parameters)
        if (parameter.name == name) return &parameter;
    return nullptr;
}

Error unknown_metric(const std::string& metric) {
    std::vector<std::string> keys;
    for (const MetricEntry& entry : metric_registry()) keys.emplace_back(entry.key);
    const std::string nearest = nearest_word(metric, keys);
    return bad_input(
        fmt::format("unknown metric \"{}\"", metric),
        fmt::format("{}{}", fmt::join(keys, ", "), nearest.empty() ? "" : fmt::format(" (nearest: {})", nearest)));
}

Error unknown_parameter(const MetricEntry& entry, const std::string& name) {
    std::vector<std::string_view> names;
    for (const MetricParameter& parameter : entry.parameters) names.push_back(parameter.name);
    for (const MetricFormula& formula : entry.formulas) names.push_back(formula.name);
    if (names.empty()) names.emplace_back("none");
    return bad_input(fmt::format("metric \"{}\" has no parameter \"{}\"", entry.key, name),
                     fmt::format("{}", fmt::join(names, ", ")));
}

// Of what is not given only a needed one is put in: the others are what the maker knows.
Result<std::shared_ptr<const Spacetime>> made_of_formulas(const MetricEntry& entry,
                                                          const std::map<std::string, std::string>& formulas) {
    std::map<std::string, std::string> texts;
    for (const MetricFormula& formula : entry.formulas)
        if (formula.needed) texts.emplace(formula.name, formula.fallback);
    for (const auto& [name, text] : formulas) {
        const auto is_it = [&, &word = name](const MetricFormula& formula) { return formula.name == word; };
        if (std::none_of(entry.formulas.begin(), entry.formulas.end(), is_it)) return unknown_parameter(entry, name);
        texts[name] = text;
    }
    return entry.make_of_formulas(texts);
}

}  // namespace

std::span<const MetricEntry> metric_registry() {
    static const std::vector<MetricEntry> entries = {
        {"schwarzschild", "A black hole without spin or charge.", {}, plain},
        {"reissner-nordstrom",
         "A black hole with electric charge, or the naked charge that is left above Q/M = 1.",
         {{"charge", 0.5, 0.0, NakedCharge::kMost,
           "Charge Q/M: 0 is Schwarzschild, 1 the extremal hole; above there is no horizon, and above 1.06066 no "
           "photon sphere."}},
         charged},
        {"kerr",
         "A rotating black hole.",
         {{"spin", 0.9, -1.0, 1.0, "Spin a/M, below 0 about -z: 0 is Schwarzschild."}},
         rotating},
        {"kerr-newman",
         "A rotating black hole with electric charge.",
         {{"spin", 0.6, -1.0, 1.0, "Spin a/M, below 0 about -z: 0 is Reissner-Nordstrom."},
          {"charge", 0.6, 0.0, 1.0, "Charge Q/M: 0 is Kerr. spin^2 + charge^2 is at most 1."}},
         rotating_charged,
         check_rotating_charged},
        {"neutron-star",
         "A star without spin or charge, with a patterned surface.",
         {{"radius", 2.5, NeutronStar::kLeastRadius, NeutronStar::kLargestRadius,
           "Radius of the surface, r_s; at least 9/8, what pressure can hold up."}},
         [](const Numbers& of) -> Made { return std::make_unique<NeutronStar>(of.at("radius")); }},
        {"ellis",
         "A wormhole between two skies, the simplest: no tides, no redshift.",
         {{"throat", 1.0, 0.01, 100.0, "Radius of the throat."}},
         [](const Numbers& of) -> Made { return std::make_unique<Ellis>(of.at("throat")); }},
        {"dneg-wormhole",
         "The wormhole of James, von Tunzelmann, Franklin and Thorne (2015): a tube of any length, lensing as gentle "
         "as wanted.",
         {{"throat", 1.0, 0.01, 100.0, "Radius of the throat."},
          {"length", 0.01, 0.0, DnegWormhole::kLongest, "Length of the tube, in throat radii."},
          {"lensing_width", 0.05, DnegWormhole::kNarrowest, DnegWormhole::kWidest,
           "Width of the region outside the tube that bends light, in throat radii."}},
         [](const Numbers& of) -> Made {
             return std::make_unique<DnegWormhole>(of.at("throat"), of.at("length"), of.at("lensing_width"));
         }},
        {"janis-newman-winicour",
         "A mass with a scalar field: a photon sphere about a singular surface.",
         {{"gamma", 0.8, JanisNewmanWinicour::kLeast, 1.0, "Mass over what it is with its field: 1 is Schwarzschild."}},
         [](const Numbers& of) -> Made { return std::make_unique<JanisNewmanWinicour>(of.at("gamma")); }},
        {"formula",
         "A static spherical hole given by formulas: ds^2 = -A dt^2 + B dr^2 + R^2 dOmega^2.",
         {},
         nullptr,
         nullptr,
         {{"A", "1 - 1/r", true, "Minus g_tt: above 0 outside of the horizon, where it falls through 0."},
          {"B", "1/A", false, "g_rr."},
          {"R", "r", false, "Areal radius."}},
         FormulaMetric::make},
        {"minkowski", "Flat spacetime: light travels straight.", {}, flat},
    };
    return entries;
}

const MetricEntry* find_metric(std::string_view key) {
    for (const MetricEntry& entry : metric_registry())
        if (entry.key == key) return &entry;
    return nullptr;
}

Result<std::shared_ptr<const Spacetime>> make_spacetime(const std::string& metric, const MetricParameters& parameters) {
    const MetricEntry* entry = find_metric(metric);
    if (entry == nullptr) return unknown_metric(metric);
    std::map<std::string, double> complete;
    for (const MetricParameter& parameter : entry->parameters) complete.emplace(parameter.name, parameter.fallback);
    for (const auto& [name, value] : parameters) {
        const MetricParameter* parameter = find_parameter(*entry, name);
        if (parameter == nullptr) return unknown_parameter(*entry, name);
        if (!(value >= parameter->low && value <= parameter->high))  // NaN too
            return bad_key(name, fmt::format("{} is out of range", value),
                           fmt::format("[{}, {}]", parameter->low, parameter->high));
        complete[name] = value;
    }
    if (entry->make_of_formulas != nullptr) return made_of_formulas(*entry, parameters.formulas);
    if (!parameters.formulas.empty()) return unknown_parameter(*entry, parameters.formulas.begin()->first);
    if (entry->check != nullptr)
        if (const Status fits = entry->check(complete); !fits) return fits.error();
    return std::shared_ptr<const Spacetime>(entry->make(complete));
}

}  // namespace nullscope
