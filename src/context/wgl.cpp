// WGL, of Windows: the driver of the graphics card, in a window that is never shown.
#include <utility>

#include "context/context.h"
#include "platform/gl_window.h"

namespace nullscope {
namespace {

class WglContext final : public GlContext {
public:
    explicit WglContext(std::unique_ptr<platform::GlWindow> window) : window_(std::move(window)) {}
    GlProc get_proc_address(const char* name) const override { return reinterpret_cast<GlProc>(window_->symbol(name)); }
    std::string kind() const override { return "wgl"; }

private:
    std::unique_ptr<platform::GlWindow> window_;
};

}  // namespace

Result<std::unique_ptr<GlContext>> make_wgl_context() {
    std::string why;
    auto window = platform::make_gl_window(why);
    if (!window) return failed("WGL: " + why);
    return std::unique_ptr<GlContext>(std::make_unique<WglContext>(std::move(window)));
}

}  // namespace nullscope
