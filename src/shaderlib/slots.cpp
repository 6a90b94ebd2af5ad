#include "shaderlib/slots.h"

#include <fmt/format.h>

#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

struct SlotRow {
    Slot slot;
    std::string_view name, define, type, function, parameters, arguments;
    std::string_view join;  // of the functions' values
    // No function: the file of the one effect that may be in the slot has the functions under their own names.
};

constexpr SlotRow kSlots[] = {
    {Slot::kDiscGlow, "generated/disc_glow", "SLOT_DISC_GLOW", "vec3", "disc_glow",
     "Trace trace, DiscCrossing crossing, float delay", "trace, crossing, delay", " + "},
    {Slot::kDiscLight, "generated/disc_light", "SLOT_DISC_LIGHT", "float", "disc_light", "float cosine", "cosine",
     " * "},
    {Slot::kMedium, "generated/medium", "SLOT_MEDIUM", "", "", "", "", ""},
};

}  // namespace

std::vector<SlotText> slot_texts(const EffectSet& effects) {
    std::vector<SlotText> texts;
    for (const SlotRow& row : kSlots) {
        std::string includes, value;
        for (const Effect effect : effects.list())
            if (const SlotPart& part = effect_row(effect).part; part.slot == row.slot) {
                includes += include_line(part.file);
                value += fmt::format("{}{}({})", value.empty() ? "" : row.join, part.function, row.arguments);
            }
        if (row.function.empty() && !value.empty())
            texts.push_back({row.slot, row.name, row.define, includes});
        else if (!value.empty())
            texts.push_back({row.slot, row.name, row.define,
                             fmt::format("{}{} {}({}) {{ return {}; }}\n", includes, row.type, row.function,
                                         row.parameters, value)});
    }
    return texts;
}

}  // namespace nullscope
