// Slots of the shader's text: where effects stand side by side, each by one function of its own file (SlotPart of its row). A
// file of shaders/ includes "generated/NAME" within #ifdef SLOT_NAME and calls NAME, which calls the functions of all active
// effects of the slot.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plan/effects.h"

namespace nullscope {

struct SlotText {
    Slot slot;
    std::string_view name;    // what stands for it: "generated/disc_glow"
    std::string_view define;  // that something is in it: "SLOT_DISC_GLOW"
    std::string text;
};

// Of the slots that these effects fill.
std::vector<SlotText> slot_texts(const EffectSet& effects);

}  // namespace nullscope
