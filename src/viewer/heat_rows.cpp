#include "viewer/heat_rows.h"

#include <array>
#include <cstddef>

#include "scenefile/scene_keys.h"
#include "viewer/length_fields.h"
#include "viewer/panel_rows.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr std::array kShinesBy = {"accretion", "powers of the radius", "a table",
                                  "a lamp on its axis"};  // as Emissivity
constexpr double kSteepest = 10.0, kLeastIndex = 1.0, kMostIndex = 3.5;
constexpr double kLeastHeight = 1.02, kMostHeight = 100.0;  // of the lamp, over the horizon's radius; r_s

bool power_rows(EmissivitySpec& spec, const NumberStyle& style) {
    const std::array<double*, kMostBreaks + 1> powers{&spec.powers.x, &spec.powers.y, &spec.powers.z};
    constexpr std::array kPowers = {"Power", "Second power", "Third power"};
    constexpr std::array kBreaks = {"Break", "Second break"};
    bool changed = false;
    for (std::size_t i = 0; i <= spec.breaks.size(); ++i) {
        changed |= slide(kPowers[i], *powers[i], -kSteepest, kSteepest, "%.2f", "q of an emissivity r^-q.");
        if (i == spec.breaks.size()) break;
        KeyRange range = key_range("disc.breaks");
        if (i > 0) range.low = spec.breaks[i - 1];
        if (i + 1 < spec.breaks.size()) range.high = spec.breaks[i + 1];
        changed |= drag_length(kBreaks[i], spec.breaks[i], 0.02, range, range.low, range.high, style,
                               "Radius where one power meets the next.");
    }
    return changed;
}

}  // namespace

bool heat_rows(DiscSpec& disc, double horizon, const NumberStyle& style, bool escape) {
    bool changed = false;
    EmissivitySpec& spec = disc.emissivity;
    row("Shines by", "What heats the disc at each radius. The hottest ring has the disc's temperature.");
    choice("##emissivity", kShinesBy[static_cast<std::size_t>(spec.by)], escape, [&] {
        for (std::size_t i = 0; i < kShinesBy.size(); ++i) {
            const auto by = static_cast<Emissivity>(i);
            if ((by == Emissivity::kTable && spec.file.empty()) || (by != Emissivity::kAccretion && disc.accretion))
                continue;
            if (!choice_item(kShinesBy[i], by == spec.by) || by == spec.by) continue;
            spec.by = by, changed = true;
            spec.lamp.height = std::max(spec.lamp.height, kLeastHeight * horizon);
        }
    });
    if (spec.by == Emissivity::kPowerLaw) changed |= power_rows(spec, style);
    if (spec.by == Emissivity::kLamp) {
        KeyRange height = key_range("disc.lamp_height");
        height.low = std::max(kLeastHeight * horizon, 0.01);
        changed |= drag_length("Lamp", spec.lamp.height, 0.02, height, height.low, kMostHeight, style,
                               "Height of the lamp on the disc's axis.");
        changed |= slide_key("disc.lamp_index", "Index", spec.lamp.index, kLeastIndex, kMostIndex, "%.2f",
                             "Photon index of the lamp's spectrum; 2 is the energy that arrives.");
    }
    return changed;
}

}  // namespace nullscope::viewer
