// What light does on its way and before the display shows it: switches to teach with, and the picture's development.
#include <imgui.h>

#include <cstddef>
#include <string>

#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

template <std::size_t Count>
bool choose(const char* label, const char* const (&names)[Count], int& chosen, const char* help, bool escape) {
    bool changed = false;
    row(label, help);
    if (!begin_choice((std::string("##") + label).c_str(), names[chosen], escape)) return false;
    for (int i = 0; i < static_cast<int>(Count); ++i)
        if (choice_item(names[i], i == chosen)) chosen = i, changed = true;
    end_choice();
    return changed;
}

}  // namespace

bool light_section(ViewState& view, bool escape) {
    LightSpec& light = view.scene.light;
    PictureSpec& picture = view.scene.picture;
    bool changed = false;
    const auto any = [&changed](bool one) { changed = changed || one; };
    any(tick("Lensing", light.lensing,
             "Light follows the geodesics of the metric; else it goes straight, and all else stays."));
    any(tick("Shift", light.shift,
             "Motion and gravity change the colour of what shines by its heat: a thermal disc, point stars."));
    any(tick("Beaming", light.beaming, "They change its brightness."));
    any(tick("Doppler", light.doppler, "Motion of matter and camera changes frequencies: one part of g."));
    any(tick("Gravity", light.gravity, "The way out of gravity changes frequencies: the other part of g."));
    any(tick("Aberration", light.aberration, "A moving camera sees other directions than one at rest in its place."));
    any(tick("All wavelengths", light.bolometric,
             "Brightness is power at all wavelengths, not what the eye sees of it."));
    constexpr const char* kTones[] = {"shoulder", "film", "neutral"};
    int tone = static_cast<int>(picture.tone);
    if (choose("Tone", kTones, tone, "How bright light is compressed.", escape)) {
        picture.tone = static_cast<ToneCurve>(tone);
        changed = true;
    }
    constexpr double kMostBloom = 0.5;
    any(slide("Bloom", picture.bloom, 0.0, kMostBloom, Scale::kLinear, When::kNow, "%.2f",
              "Share of the light that lens and eye scatter."));
    any(tick("Auto exposure", picture.auto_exposure, "Exposure follows the picture's mean luminance."));
    any(tick("Dither", picture.dither, "Noise of half a step of 8 bits, so that dark gradients show no bands."));
    any(tick("Grid", view.show_grid, "Lines of coordinates on the sky and the disc instead of their own looks."));
    tick("Probe", view.show_probe,
         "The ray of the pixel under the cursor: its way, its numbers, both parts of g (key P).");
    return changed;
}

}  // namespace nullscope::viewer
