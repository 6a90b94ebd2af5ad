// The colours of the panels: a dark set and a light one, of which one is in use. No window, no OpenGL.
#pragma once

namespace nullscope::viewer {

struct Colour {
    float red, green, blue, opacity = 1.0f;  // display-encoded, 0 to 1
    Colour with(float other_opacity) const { return {red, green, blue, other_opacity}; }
};

// Texts (text, dim, accent, refusal, measured) keep a contrast of 4.5 to 1 (WCAG 2.1, 1.4.3) on a panel over any picture.
struct Palette {
    Colour text, dim;
    Colour panel;                                        // lets some of the picture through
    Colour field, over, held;                            // of controls: at rest, under the pointer, pressed
    Colour header;                                       // of sections
    Colour title() const { return header.with(0.95f); }  // the bar of a window: no panel is behind it
    Colour faint, border;                                // lines
    Colour accent, grab;                                 // what is chosen; what can be dragged, under a number
    Colour dragged() const { return grab.with(grab.opacity + 0.1f); }
    Colour refusal, measured;  // words that refuse; true errors beside promised ones
};

const Palette& dark_palette();
const Palette& light_palette();
// The one in use: the dark one until another was chosen. By the thread that draws the panels alone.
const Palette& palette();
void use_palette(bool light);

}  // namespace nullscope::viewer
