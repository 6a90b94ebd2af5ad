#include "viewer/length_fields.h"

#include <functional>
#include <string>

#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

// `control` changes a number in the style's unit, written with `decimals` in r_s and with six digits or more in others.
bool in_unit(double& length, const NumberStyle& style, const char* decimals,
             const std::function<bool(double& number, double one, const char* format)>& control) {
    const LengthScale scale = length_scale(style);
    const bool own = scale.one == 1.0;
    const std::string format = (own ? std::string(decimals) : "%.8g") + (*scale.name != '\0' ? " " : "") + scale.name;
    double number = scale.one * length;
    if (!control(number, scale.one, format.c_str())) return false;
    length = number / scale.one;
    return true;
}

}  // namespace

bool type_length(const char* name, double& length, double low, double high, const NumberStyle& style,
                 const char* help) {
    return in_unit(length, style, "%.6f", [&](double& number, double one, const char* format) {
        return type_number(name, number, one * low, one * high, format, help);
    });
}

bool drag_length(const char* name, double& length, double speed, const KeyRange& allowed, double low, double high,
                 const NumberStyle& style, const char* help) {
    return in_unit(length, style, "%.2f", [&](double& number, double one, const char* format) {
        const KeyRange in{one * allowed.low, one * allowed.high, allowed.open_low, allowed.open_high};
        return drag_number(name, number, one * speed, in, one * low, one * high, format, help);
    });
}

}  // namespace nullscope::viewer
