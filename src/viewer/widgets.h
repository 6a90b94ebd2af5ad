// Rows of a panel: a name on the left, a control that fills the rest, an explanation under the pointer.
#pragma once
#include <string>

namespace nullscope::viewer {

// Starts a row; the control that follows takes its rest. help: shown while the pointer is on the name.
void row(const char* name, const char* help = nullptr);
void text_row(const char* name, const char* help = nullptr);  // the same for words alone: less tall
void tooltip(const char* text);                               // of the item before, wrapped

void paragraph(const std::string& text, int colour);  // broken at spaces alone, not within numbers; colour: an ImGuiCol

// All return true when the value changed, always to a finite one in [low, high]. format: of printf.
bool drag_number(const char* name, double& value, double speed, double low, double high, const char* format,
                 const char* help);
bool drag_degrees(const char* name, double& radians, double low_deg, double high_deg, const char* help);

enum class Scale { kLinear, kLogarithmic };
enum class When { kNow, kOnRelease };  // kOnRelease: for what takes a while to build
bool slide(const char* name, double& value, double low, double high, Scale scale, When when, const char* format,
           const char* help);

bool tick(const char* name, bool& value, const char* help = nullptr);  // a box to tick

// The control of a row that was started: slides over a number whose own scale is not what is shown. flags: of ImGui's sliders.
bool slide_as(const char* id, double& position, double low, double high, int flags, const std::string& text);

// The control of a row that was started: typed in, taken over on Enter or when left.
bool type_number(const char* id, double& value, double low, double high, const char* format);

// A box with a list below it; false if closed, else end it with end_choice. shut: closes the list (Escape).
bool begin_choice(const char* id, const std::string& shown, bool shut);
void end_choice();
bool choice_item(const std::string& text, bool chosen, const std::string& help = {});

}  // namespace nullscope::viewer
