// Rows of a panel: a name on the left, a control that fills the rest, an explanation under the pointer.
#pragma once
#include <functional>
#include <string>

#include "scene/scene_key.h"
#include "studio/palette.h"

namespace nullscope::viewer {

float em();                             // the font's size, by which everything is measured
unsigned packed(const Colour& colour);  // as Dear ImGui takes it

// Whether a text has all the words of a search, in upper or lower case.
bool has_words(const std::string& text, const std::string& search);

// Lines no wider than that where spaces allow it: Dear ImGui's own wrapping breaks numbers at their point.
std::string wrapped(const std::string& text, float width);

// Starts a row; the control that follows takes its rest. help: shown while the pointer is on the name.
void row(const char* name, const std::string& help = {});
void text_row(const char* name, const std::string& help = {});  // the same for words alone: less tall

// Of the item before, wrapped: below or above its row, or, of the entries of a list, beside the list.
enum class TooltipPlace { kBelow, kBesideWindow };
void tooltip(const std::string& text, TooltipPlace place = TooltipPlace::kBelow);

// Dim words, or the reddish ones of a refusal; broken at spaces alone, not within numbers.
void wrapped_text(const std::string& text, float width);  // broken at spaces where those are enough
void paragraph(const std::string& text, bool refusal = false);

// Stays on the line of the item before where so much more fits on it; true if it does.
bool next_to(float width);
float button_width(const char* name);
bool small_button(const char* name);  // as tall as a line of text, tails of letters included

// Where little of what lies between y (of the screen) and the cursor is seen: scrolls so far that all of it is, or, of what is taller than
// the window, its top.
void scroll_into_view(float y);

enum class Scale { kLinear, kLogarithmic };
enum class When { kNow, kOnRelease };  // kOnRelease: for what takes a while to build

// All return true when the value changed, always to a finite one that is allowed, in [low, high] where nothing else is said. format: of
// printf.
// allowed: what can be typed in; the pointer drags it between low and high.
bool drag_number(const char* name, double& value, double speed, const KeyRange& allowed, double low, double high,
                 const char* format, const char* help);
// Of an angle of scene files ("disc.rotation"): over all that the file may say.
bool drag_key_degrees(const char* key, const char* name, double& radians, const char* help);
bool slide(const char* name, double& value, double low, double high, const char* format, const std::string& help,
           Scale scale = Scale::kLinear, When when = When::kNow);
// Of a key of scene files ("disc.temperature"), in the file's unit: slides over low to high; all that the file may say can be typed in,
// which the help says.
bool slide_key(const char* key, const char* name, double& value, double low, double high, const char* format,
               const std::string& help, Scale scale = Scale::kLinear, When when = When::kNow);
bool slide_key_degrees(const char* key, const char* name, double& radians, double low_deg, double high_deg,
                       const char* help, When when = When::kNow);
// Slides over a number whose own scale is not what is shown: text.
bool slide_as(const char* name, double& position, double low, double high, const std::string& text, const char* help,
              Scale scale = Scale::kLinear);
// Typed in, taken over on Enter or when left.
bool type_number(const char* name, double& value, double low, double high, const char* format, const char* help);
// Whether such a field, or a slider's own text, has the keyboard.
bool types_number();

// A line of text, with a hint while it is empty. True when Enter was pressed.
bool input_text(const char* id, const char* hint, std::string& text);

bool tick(const char* name, bool& value, const char* help = "");  // a box to tick

// The same where it means something; else grey, and the name says why.
bool tick_if(bool meant, const char* name, bool& value, const char* help, const char* why_not);

// One of three buttons side by side, `place` 0, 1 or 2 from the left.
bool button_of_three(int place, const char* name, const std::string& help);

// A box with a list below it, which `items` draws; false if it is closed. shut: closes the list (Escape).
bool choice(const char* id, const std::string& shown, bool shut, const std::function<void()>& items);
bool choice_item(const std::string& text, bool chosen, const std::string& help = {});

// A small window over the picture, with its pivot (0 ... 1, from the top left) at a place. kTop: over all panels, whichever was opened or
// clicked last.
enum class OverlayLayer { kPanels, kTop };
void overlay(const char* id, float x, float y, float pivot_x, float pivot_y, float opacity,
             const std::function<void()>& content, OverlayLayer layer = OverlayLayer::kPanels);

}  // namespace nullscope::viewer
