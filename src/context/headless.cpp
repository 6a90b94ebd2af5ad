#include <fmt/format.h>

#include "context/context.h"

namespace nullscope {
namespace {

std::string words_of(const ContextDevice& device) {
    return device.place.empty() ? device.kind : fmt::format("{} {}", device.kind, device.place);
}

Result<std::unique_ptr<GlContext>> make_context_on(int number) {
    const std::vector<ContextDevice> devices = context_devices();
    if (number >= 0 && number < static_cast<int>(devices.size()))
        return devices[static_cast<std::size_t>(number)].kind == "egl" ? make_egl_context(number)  // they come first
                                                                       : make_osmesa_context();
    std::string list;
    for (std::size_t i = 0; i < devices.size(); ++i)
        list += fmt::format("{}{} ({})", i == 0 ? "" : ", ", i, words_of(devices[i]));
    return bad_input(fmt::format("--device {}: there is none of this number", number),
                     list.empty() ? "none: neither EGL nor OSMesa is installed" : list + "; see: nullscope devices");
}

}  // namespace

std::vector<ContextDevice> context_devices() {
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
    if (kind == "egl") return make_egl_context();
    if (kind == "osmesa") return make_osmesa_context();
    if (kind != "auto") return bad_input(fmt::format("context \"{}\" is not known", kind), "auto, egl, osmesa");
    auto egl = make_egl_context();
    if (egl) return egl;
    auto osmesa = make_osmesa_context();
    if (osmesa) return osmesa;
    return failed("no OpenGL 3.3 context: " + egl.error().message() + "; " + osmesa.error().message());
}

}  // namespace nullscope
