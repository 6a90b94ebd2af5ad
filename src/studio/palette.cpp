#include "studio/palette.h"

namespace nullscope::viewer {
namespace {

constexpr Palette kDark = {
    .text = {0.90f, 0.91f, 0.93f},
    .dim = {0.58f, 0.61f, 0.66f},
    .panel = {0.045f, 0.050f, 0.065f, 0.86f},
    .field = {0.16f, 0.18f, 0.22f, 0.75f},
    .over = {0.24f, 0.27f, 0.33f, 0.85f},
    .held = {0.31f, 0.34f, 0.41f, 0.95f},
    .header = {0.13f, 0.145f, 0.18f, 0.60f},
    .faint = {1.00f, 1.00f, 1.00f, 0.07f},
    .border = {1.00f, 1.00f, 1.00f, 0.16f},  // of boxes over a bright disc too
    .accent = {0.96f, 0.67f, 0.33f},
    .grab = {0.80f, 0.45f, 0.12f, 0.55f},  // the number shows through
    .refusal = {1.00f, 0.52f, 0.45f},
    .measured = {0.43f, 0.80f, 1.00f},
};
constexpr Palette kLight = {
    .text = {0.09f, 0.10f, 0.13f},
    .dim = {0.34f, 0.36f, 0.41f},
    .panel = {0.955f, 0.960f, 0.970f, 0.93f},
    .field = {0.85f, 0.865f, 0.89f, 0.90f},
    .over = {0.78f, 0.80f, 0.84f, 0.95f},
    .held = {0.71f, 0.74f, 0.79f, 1.00f},
    .header = {0.80f, 0.82f, 0.86f, 0.70f},
    .faint = {0.00f, 0.00f, 0.00f, 0.10f},
    .border = {0.00f, 0.00f, 0.00f, 0.22f},
    .accent = {0.58f, 0.28f, 0.00f},
    .grab = {0.95f, 0.62f, 0.24f, 0.80f},
    .refusal = {0.70f, 0.10f, 0.07f},
    .measured = {0.00f, 0.33f, 0.58f},
};
bool in_use_is_light = false;

}  // namespace

const Palette& dark_palette() { return kDark; }
const Palette& light_palette() { return kLight; }
const Palette& palette() { return in_use_is_light ? kLight : kDark; }
void use_palette(bool light) { in_use_is_light = light; }

}  // namespace nullscope::viewer
