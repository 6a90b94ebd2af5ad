// An OpenGL 3.3 core context without a window: EGL (a device or Mesa's surfaceless platform) or OSMesa, both opened at run time; on Windows that
// of a window which is never shown (WGL).
// Only one is current in a thread at a time; drawing goes to framebuffer objects.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace nullscope {

using GlProc = void (*)();

class GlContext {
public:
    virtual ~GlContext() = default;
    virtual GlProc get_proc_address(const char* name) const = 0;
    virtual std::string kind() const = 0;  // of context_kinds()
};

// A place that contexts can be had from: a device of EGL, one of its platforms without a device, or OSMesa. What is there need not give one.
struct ContextDevice {
    std::string kind;   // of context_kinds()
    std::string place;  // "device 0", "surfaceless", "default display"; OSMesa: empty
    std::string file;   // of the GPU, where the driver says it: "/dev/dri/card0"
};

// That this system has, in the order that "auto" tries them: "egl", "osmesa"; on Windows "wgl".
std::vector<std::string> context_kinds();

// What a program asks for: a kind of context or "auto" (the first that works); or the number of a device.
struct ContextChoice {
    ContextChoice() = default;
    ContextChoice(std::string asked) : kind(std::move(asked)) {}  // NOLINT: implicit on purpose
    ContextChoice(const char* asked) : kind(asked) {}             // NOLINT: implicit on purpose
    static ContextChoice of_device(int number) {
        ContextChoice choice;
        choice.device = number;
        return choice;
    }
    std::string kind = "auto";
    std::optional<int> device{};  // in context_devices()
    bool is_auto() const { return kind == "auto" && !device; }
    friend bool operator==(const ContextChoice&, const ContextChoice&) = default;
};

// In the order that "auto" tries them. Loads the libraries that are installed and asks them; makes no context.
std::vector<ContextDevice> context_devices();

// Errors: the library is not installed, or no context of version 3.3 core can be had; the sentence says which and what to do.
std::vector<ContextDevice> egl_devices();
Result<std::unique_ptr<GlContext>> make_egl_context(
    std::optional<int> device = {});  // in egl_devices(); else the first that works
bool has_osmesa();
Result<std::unique_ptr<GlContext>> make_osmesa_context();
Result<std::unique_ptr<GlContext>> make_wgl_context();

// The context is current on return. Errors: those above; a number that no device has.
Result<std::unique_ptr<GlContext>> make_headless_context(const ContextChoice& choice);

}  // namespace nullscope
