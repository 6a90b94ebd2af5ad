#include "spacetime/registry.h"

#include <fmt/format.h>

#include "base/text.h"
#include "spacetime/dneg_wormhole.h"
#include "spacetime/ellis.h"
#include "spacetime/janis_newman_winicour.h"
#include "spacetime/kerr.h"
#include "spacetime/kerr_newman.h"
#include "spacetime/minkowski.h"
#include "spacetime/naked_charge.h"
#include "spacetime/neutron_star.h"
#include "spacetime/reissner_nordstrom.h"
#include "spacetime/schwarzschild.h"

namespace nullscope {
namespace {

const MetricParameter* find_parameter(const MetricEntry& entry, std::string_view name) {
    for (const MetricParameter& parameter : entry.parameters) {
        if (parameter.name == name) return &parameter;
    }
    return nullptr;
}

Error unknown_metric(const std::string& metric) {
    std::vector<std::string> keys;
    std::string list;
    for (const MetricEntry& entry : metric_registry()) {
        keys.emplace_back(entry.key);
        list += (list.empty() ? "" : ", ") + std::string(entry.key);
    }
    const std::string nearest = nearest_word(metric, keys);
    return bad_input(fmt::format("unknown metric \"{}\"; allowed: {}{}", metric, list,
                                 nearest.empty() ? "" : fmt::format(" (nearest: {})", nearest)));
}

Error unknown_parameter(const MetricEntry& entry, const std::string& name) {
    std::string list;
    for (const MetricParameter& parameter : entry.parameters) {
        list += (list.empty() ? "" : ", ") + std::string(parameter.name);
    }
    return bad_input(fmt::format("metric \"{}\" has no parameter \"{}\"; allowed: {}", entry.key, name,
                                 list.empty() ? "none" : list));
}

}  // namespace

std::span<const MetricEntry> metric_registry() {
    static const std::vector<MetricEntry> entries = {
        {"schwarzschild", "A black hole without spin or charge.", {}, make_schwarzschild},
        {"reissner-nordstrom",
         "A black hole with electric charge, or the naked charge that is left above Q/M = 1.",
         {{"charge", 0.5, 0.0, NakedCharge::kMost,
           "Charge Q/M: 0 is Schwarzschild, 1 the extremal hole; above there is no horizon, and above 1.06066 no "
           "photon sphere."}},
         make_reissner_nordstrom},
        {"kerr", "A rotating black hole.", {{"spin", 0.9, 0.0, 0.9999, "Spin a/M: 0 is Schwarzschild."}}, make_kerr},
        {"kerr-newman",
         "A rotating black hole with electric charge.",
         {{"spin", 0.6, 0.0, 0.9999, "Spin a/M: 0 is Reissner-Nordstrom."},
          {"charge", 0.6, 0.0, 0.9999, "Charge Q/M: 0 is Kerr. spin^2 + charge^2 stays below 1."}},
         make_kerr_newman,
         kerr_newman_fault},
        {"neutron-star",
         "A star without spin or charge, with a patterned surface.",
         {{"radius", 2.5, NeutronStar::kLeastRadius, NeutronStar::kLargestRadius,
           "Radius of the surface, r_s; at least 9/8, what pressure can hold up."}},
         make_neutron_star},
        {"ellis",
         "A wormhole between two skies, the simplest: no tides, no redshift.",
         {{"throat", 1.0, 0.01, 100.0, "Radius of the throat."}},
         make_ellis},
        {"dneg-wormhole",
         "The wormhole of James, von Tunzelmann, Franklin and Thorne (2015): a tube of any length, lensing as gentle "
         "as wanted.",
         {{"throat", 1.0, 0.01, 100.0, "Radius of the throat."},
          {"length", 0.01, 0.0, DnegWormhole::kLongest, "Length of the tube, in throat radii."},
          {"lensing_width", 0.05, DnegWormhole::kNarrowest, DnegWormhole::kWidest,
           "Width of the region outside the tube that bends light, in throat radii."}},
         make_dneg_wormhole},
        {"janis-newman-winicour",
         "A mass with a scalar field: a photon sphere about a singular surface.",
         {{"gamma", 0.8, JanisNewmanWinicour::kLeast, 1.0, "Mass over what it is with its field: 1 is Schwarzschild."}},
         make_janis_newman_winicour},
        {"minkowski", "Flat spacetime: light runs straight.", {}, make_minkowski},
    };
    return entries;
}

const MetricEntry* find_metric(std::string_view key) {
    for (const MetricEntry& entry : metric_registry()) {
        if (entry.key == key) return &entry;
    }
    return nullptr;
}

Result<std::shared_ptr<const Spacetime>> make_spacetime(const std::string& metric,
                                                        const std::map<std::string, double>& parameters) {
    const MetricEntry* entry = find_metric(metric);
    if (entry == nullptr) return unknown_metric(metric);
    std::map<std::string, double> complete;
    for (const MetricParameter& parameter : entry->parameters) complete.emplace(parameter.name, parameter.fallback);
    for (const auto& [name, value] : parameters) {
        const MetricParameter* parameter = find_parameter(*entry, name);
        if (parameter == nullptr) return unknown_parameter(*entry, name);
        if (!(value >= parameter->low && value <= parameter->high)) {  // NaN too
            return bad_input(fmt::format("{} = {} is out of range; allowed: [{}, {}]", name, value, parameter->low,
                                         parameter->high));
        }
        complete[name] = value;
    }
    if (entry->fault != nullptr)
        if (const auto fault = entry->fault(complete)) return bad_input(*fault);
    return std::shared_ptr<const Spacetime>(entry->make(complete));
}

}  // namespace nullscope
