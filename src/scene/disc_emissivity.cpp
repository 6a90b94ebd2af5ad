#include "scene/disc_emissivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace nullscope {
namespace {

double power_law(const EmissivitySpec& spec, double r) {
    const double q[] = {spec.powers.x, spec.powers.y, spec.powers.z};
    double value = 1.0, from = 1.0;  // where r^-q[0] is 1
    std::size_t piece = 0;
    for (; piece < spec.breaks.size() && r > spec.breaks[piece]; ++piece) {
        value *= std::pow(spec.breaks[piece] / from, -q[piece]);
        from = spec.breaks[piece];
    }
    return value * std::pow(r / from, -q[piece]);
}

double between_rows(const std::vector<EmissivityRow>& rows, double r) {
    if (!(r >= rows.front().r && r <= rows.back().r)) return 0.0;
    const auto after = std::ranges::lower_bound(rows, r, {}, &EmissivityRow::r);
    if (after == rows.begin()) return after->value;
    const EmissivityRow &a = *(after - 1), &b = *after;
    return a.value * std::pow(b.value / a.value, std::log(r / a.r) / std::log(b.r / a.r));
}

}  // namespace

std::vector<double> disc_emissivity(const Spacetime& spacetime, const std::vector<double>& radii,
                                    const EmissivitySpec& spec, Sense sense) {
    if (spec.by == Emissivity::kLamp) return lamp_light(spacetime, radii, spec.lamp, sense);
    std::vector<double> values(radii.size(), 0.0);
    if (spec.by == Emissivity::kPowerLaw)
        std::ranges::transform(radii, values.begin(), [&](double r) { return power_law(spec, r); });
    if (spec.by == Emissivity::kTable)
        if (const auto rows = load_emissivity(spec.file))
            std::ranges::transform(radii, values.begin(), [&](double r) { return between_rows(**rows, r); });
    return values;
}

std::vector<double> disc_emissivity_shares(const Spacetime& spacetime, const std::vector<double>& radii,
                                           const EmissivitySpec& spec, Sense sense) {
    std::vector<double> kinks;
    if (spec.by == Emissivity::kPowerLaw) kinks = spec.breaks;
    if (spec.by == Emissivity::kTable)
        if (const auto rows = load_emissivity(spec.file))
            for (const EmissivityRow& row : **rows) kinks.push_back(row.r);
    std::erase_if(kinks, [&](double r) { return !(r > radii.front() && r < radii.back()); });
    std::vector<double> shares = disc_emissivity(spacetime, radii, spec, sense);
    double most = *std::ranges::max_element(shares);
    for (const double value : disc_emissivity(spacetime, kinks, spec, sense)) most = std::max(most, value);
    for (double& share : shares) share = most > 0.0 ? share / most : 0.0;
    return shares;
}

std::string emissivity_words(const EmissivitySpec& spec) {
    switch (spec.by) {
        case Emissivity::kAccretion: return "thermal";
        case Emissivity::kTable: return "table " + without_controls(spec.file.filename().string());
        case Emissivity::kLamp: break;
        case Emissivity::kPowerLaw: {
            const double q[] = {spec.powers.x, spec.powers.y, spec.powers.z};
            std::string words;
            for (std::size_t i = 0; i < spec.breaks.size(); ++i)
                words += fmt::format("r^{:g} to {:g} r_s, ", -q[i] + 0.0, spec.breaks[i]);
            return words + fmt::format("r^{:g}", -q[spec.breaks.size()] + 0.0);
        }
    }
    const std::string index = spec.lamp.index == LampPost{}.index ? "" : fmt::format(", index {:g}", spec.lamp.index);
    return fmt::format("a lamp at {:g} r_s{}", spec.lamp.height, index);
}

}  // namespace nullscope
