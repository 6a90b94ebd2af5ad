#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "context/context.h"
#include "platform/gl_window.h"

namespace nullscope {
namespace {

std::string words_of(const ContextDevice& device) {
    return device.place.empty() ? device.kind : fmt::format("{} {}", device.kind, device.place);
}

Result<std::unique_ptr<GlContext>> make_context_of(const std::string& kind) {
    if (kind == "egl") return make_egl_context();
    return kind == "osmesa" ? make_osmesa_context() : make_wgl_context();
}

Result<std::unique_ptr<GlContext>> make_context_on(int number) {
    const std::vector<ContextDevice> devices = context_devices();
    if (number >= 0 && number < static_cast<int>(devices.size())) {
        const std::string& kind = devices[static_cast<std::size_t>(number)].kind;
        return kind == "egl" ? make_egl_context(number) : make_context_of(kind);  // EGL's come first
    }
    std::string list;
    for (std::size_t i = 0; i < devices.size(); ++i)
        list += fmt::format("{}{} ({})", i == 0 ? "" : ", ", i, words_of(devices[i]));
    return bad_input(fmt::format("--device {}: there is none of this number", number),
                     list.empty() ? "none: neither EGL nor OSMesa is installed" : list + "; see: nullscope devices");
}

}  // namespace

std::vector<std::string> context_kinds() {
    return platform::has_gl_windows() ? std::vector<std::string>{"wgl"} : std::vector<std::string>{"egl", "osmesa"};
}

std::vector<ContextDevice> context_devices() {
    if (platform::has_gl_windows()) return {{"wgl", "", ""}};
    std::vector<ContextDevice> devices = egl_devices();
    if (has_osmesa()) devices.push_back({"osmesa", "", ""});
    return devices;
}

Result<std::unique_ptr<GlContext>> make_headless_context(const ContextChoice& choice) {
    const std::string& kind = choice.kind;
    if (choice.device && kind != "auto")
        return bad_input(fmt::format("--device {}: a device is of one kind of context", *choice.device),
                         "without --context");
    if (choice.device) return make_context_on(*choice.device);
    const std::vector<std::string> kinds = context_kinds();
    if (std::ranges::find(kinds, kind) != kinds.end()) return make_context_of(kind);
    if (kind != "auto")
        return bad_input(fmt::format("context \"{}\" is not known", kind),
                         fmt::format("auto, {}", fmt::join(kinds, ", ")));
    std::string failures;
    for (const std::string& each : kinds) {
        auto context = make_context_of(each);
        if (context) return context;
        failures += (failures.empty() ? "" : "; ") + context.error().message();
    }
    return failed("no OpenGL 3.3 context: " + failures);
}

}  // namespace nullscope
