#include "command/line_emissivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/text.h"
#include "scene/disc_emissivity.h"

namespace nullscope::cli {
namespace {

constexpr double kSteepest = 20.0, kFarthest_rs = 1e6, kLargestIndex = 10.0;

Error unknown(const std::string& text) {
    return bad_input(fmt::format("--emissivity {}: not an emissivity", without_controls(text)), kEmissivityForms);
}

// "3:5:2", or nothing.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(':', from), text.size());
        const auto number = parse_number(text.substr(from, end - from));
        if (!number) return {};
        numbers.push_back(*number);
        from = end + 1;
    }
    return numbers;
}

bool within(double value, double least, double most) { return value >= least && value <= most; }

Result<EmissivitySpec> lamp_of(const std::string& text) {
    const std::vector<double> numbers = numbers_of(text.substr(std::string_view("lamp:").size()));
    EmissivitySpec spec;
    spec.by = Emissivity::kLamp;
    if (numbers.empty() || numbers.size() > 2 || !(numbers[0] > 0.0 && numbers[0] <= kFarthest_rs))
        return unknown(text);
    spec.lamp.height = numbers[0];
    if (numbers.size() == 2) spec.lamp.index = numbers[1];
    if (!within(spec.lamp.index, 0.0, kLargestIndex)) return unknown(text);
    return spec;
}

// Powers at even places, radii between them.
Result<EmissivitySpec> powers_of(const std::string& text) {
    const std::vector<double> numbers = numbers_of(text);
    if (numbers.size() % 2 == 0 || numbers.size() > 2 * kMostBreaks + 1) return unknown(text);
    EmissivitySpec spec;
    spec.by = Emissivity::kPowerLaw;
    const std::array<double*, 3> powers{&spec.powers.x, &spec.powers.y, &spec.powers.z};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool radius = i % 2 == 1;
        if (!radius && within(numbers[i], -kSteepest, kSteepest))
            *powers[i / 2] = numbers[i];
        else if (radius && numbers[i] > (i > 1 ? numbers[i - 2] : 0.0) && numbers[i] <= kFarthest_rs)
            spec.breaks.push_back(numbers[i]);
        else
            return unknown(text);
    }
    return spec;
}

}  // namespace

Result<EmissivitySpec> line_emissivity(const std::string& text, const Scene& scene) {
    EmissivitySpec spec;
    if (text == "thermal") return spec;
    if (text.empty()) {
        const bool thermal = scene.disc && scene.disc->emission == DiscEmission::kThermal;
        if (thermal && scene.disc->emissivity.by != Emissivity::kAccretion) return scene.disc->emissivity;
        spec.by = Emissivity::kPowerLaw;
        return spec;
    }
    if (text.starts_with("lamp:")) return lamp_of(text);
    if (!text.ends_with(".csv")) return powers_of(text);
    spec.by = Emissivity::kTable, spec.file = text;
    return spec;
}

Status lit_part(const EmissivitySpec& spec, const Spacetime& spacetime, double& inner, double& outer) {
    if (spec.by == Emissivity::kLamp && !(spec.lamp.height > spacetime.horizon_radius().value_or(0.0)))
        return bad_input(fmt::format("no lamp is at rest at {:g} r_s", spec.lamp.height),
                         fmt::format("a height above {:.6g}", *spacetime.horizon_radius()));
    if (spec.by != Emissivity::kTable) return Done{};
    const auto rows = load_emissivity(spec.file);
    if (!rows) {
        Error error = rows.error();
        error.file = spec.file.string();
        return error;
    }
    const double first = (*rows)->front().r, last = (*rows)->back().r;
    if (!(first < outer && last > inner) && inner != outer)
        return bad_input(fmt::format("the table's radii, {:g} to {:g} r_s, are outside of the disc", first, last),
                         fmt::format("radii within {:g} to {:g}", inner, outer));
    if (inner != outer) inner = std::max(inner, first), outer = std::min(outer, last);
    return Done{};
}

}  // namespace nullscope::cli
