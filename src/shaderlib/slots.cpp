#include "shaderlib/slots.h"

#include <fmt/format.h>

#include <utility>

#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

struct SlotRow {
    Slot slot;
    std::string_view name, define;
    // Without a function the slot is the file of the one effect that may be in it.
    std::string_view type = {}, function = {}, parameters = {}, arguments = {};
    std::string_view join = {};  // of the functions' values
};

constexpr SlotRow kSlots[] = {
    {Slot::kDiscGlow, "generated/disc_glow", "SLOT_DISC_GLOW", "vec3", "disc_glow",
     "Trace trace, DiscCrossing crossing, float delay", "trace, crossing, delay", " + "},
    {Slot::kDiscLight, "generated/disc_light", "SLOT_DISC_LIGHT", "float", "disc_light", "float cosine", "cosine",
     " * "},
    {Slot::kMedium, "generated/medium", "SLOT_MEDIUM"},
};

}  // namespace

std::vector<SlotText> slot_texts(const EffectSet& effects) {
    std::vector<SlotText> texts;
    for (const SlotRow& row : kSlots) {
        std::string text, value;
        for (const Effect effect : effects.list())
            if (const SlotPart& part = effect_row(effect).part; part.slot == row.slot) {
                text += include_line(part.file);
                value += fmt::format("{}{}({})", value.empty() ? "" : row.join, part.function, row.arguments);
            }
        if (text.empty()) continue;
        if (!row.function.empty())
            text += fmt::format("{} {}({}) {{ return {}; }}\n", row.type, row.function, row.parameters, value);
        texts.push_back({row.slot, row.name, row.define, std::move(text)});
    }
    return texts;
}

}  // namespace nullscope
