// The colours of the panels can be read: contrast as the Web Content Accessibility Guidelines 2.1 define it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "image/image_file.h"
#include "studio/palette.h"

using namespace nullscope;
using namespace nullscope::viewer;

namespace {

constexpr double kLeastContrast = 4.5;

Colour over(const Colour& top, const Colour& below) {
    const auto mix = [&](float a, float b) { return top.opacity * a + (1.0f - top.opacity) * b; };
    return {mix(top.red, below.red), mix(top.green, below.green), mix(top.blue, below.blue)};
}

double luminance(const Colour& c) {
    return 0.2126 * linear_from_srgb(c.red) + 0.7152 * linear_from_srgb(c.green) + 0.0722 * linear_from_srgb(c.blue);
}

double contrast(const Colour& a, const Colour& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

}  // namespace

TEST_CASE("texts can be read on panels and controls over black and white pictures") {
    for (const Palette* p : {&dark_palette(), &light_palette()}) {
        CAPTURE(p == &light_palette());
        for (const Colour& picture : {Colour{0, 0, 0}, Colour{1, 1, 1}}) {
            CAPTURE(picture.red);
            const Colour panel = over(p->panel, picture);
            for (const Colour& words : {p->text, p->dim, p->accent, p->refusal, p->measured})
                CHECK(contrast(words, panel) >= kLeastContrast);
            for (const Colour& control : {p->field, p->over, p->held, p->header, p->grab, p->dragged()})
                CHECK(contrast(p->text, over(control, panel)) >= kLeastContrast);
            CHECK(contrast(p->text, over(p->title(), picture)) >= kLeastContrast);
        }
    }
}

TEST_CASE("the dark palette is in use until the light one is chosen") {
    CHECK(&palette() == &dark_palette());
    use_palette(true);
    CHECK(&palette() == &light_palette());
    use_palette(false);
    CHECK(&palette() == &dark_palette());
}
