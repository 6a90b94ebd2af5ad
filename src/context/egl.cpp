// EGL: every device of EGL_EXT_platform_device in turn, then Mesa's surfaceless platform, then the default display.

#include <array>
#include <cstdint>
#include <cstring>

#include "context/context.h"
#include "context/library.h"

namespace nullscope {
namespace {

// The part of EGL 1.5 that is used here (Khronos registry, egl.xml): names, values and signatures are the standard's.
using EGLDisplay = void*;
using EGLConfig = void*;
using EGLContext = void*;
using EGLSurface = void*;
using EGLDevice = void*;
using EGLint = std::int32_t;
using EGLBoolean = unsigned int;
constexpr EGLint kNone = 0x3038, kRenderableType = 0x3040, kOpenglBit = 0x0008, kSurfaceType = 0x3033,
                 kExtensions = 0x3055;
constexpr EGLint kMajorVersion = 0x3098, kMinorVersion = 0x30FB, kProfileMask = 0x30FD, kCoreProfileBit = 0x0001;
constexpr unsigned kOpenglApi = 0x30A2, kPlatformDevice = 0x313F, kPlatformSurfaceless = 0x31DD;

struct Egl {
    void* (*get_proc_address)(const char*) = nullptr;
    EGLDisplay (*get_display)(void*) = nullptr;
    EGLBoolean (*initialize)(EGLDisplay, EGLint*, EGLint*) = nullptr;
    EGLBoolean (*terminate)(EGLDisplay) = nullptr;
    EGLBoolean (*bind_api)(unsigned) = nullptr;
    EGLBoolean (*choose_config)(EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint*) = nullptr;
    EGLContext (*create_context)(EGLDisplay, EGLConfig, EGLContext, const EGLint*) = nullptr;
    EGLBoolean (*destroy_context)(EGLDisplay, EGLContext) = nullptr;
    EGLBoolean (*make_current)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) = nullptr;
    const char* (*query_string)(EGLDisplay, EGLint) = nullptr;
    EGLDisplay (*get_platform_display)(unsigned, void*, const EGLint*) = nullptr;
    EGLBoolean (*query_devices)(EGLint, EGLDevice*, EGLint*) = nullptr;
};

const Egl* egl() {
    static Egl e;
    static const bool ok = [] {
        void* library = open_library({"libEGL.so.1", "libEGL.so"});
        if (library == nullptr) return false;
        const bool all = load_symbol(library, "eglGetProcAddress", e.get_proc_address) &&
                         load_symbol(library, "eglGetDisplay", e.get_display) &&
                         load_symbol(library, "eglInitialize", e.initialize) &&
                         load_symbol(library, "eglTerminate", e.terminate) &&
                         load_symbol(library, "eglBindAPI", e.bind_api) &&
                         load_symbol(library, "eglChooseConfig", e.choose_config) &&
                         load_symbol(library, "eglCreateContext", e.create_context) &&
                         load_symbol(library, "eglDestroyContext", e.destroy_context) &&
                         load_symbol(library, "eglMakeCurrent", e.make_current) &&
                         load_symbol(library, "eglQueryString", e.query_string);
        if (!all) return false;
        e.get_platform_display =
            reinterpret_cast<decltype(e.get_platform_display)>(e.get_proc_address("eglGetPlatformDisplayEXT"));
        e.query_devices = reinterpret_cast<decltype(e.query_devices)>(e.get_proc_address("eglQueryDevicesEXT"));
        return true;
    }();
    return ok ? &e : nullptr;
}

class EglContext final : public GlContext {
public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~EglContext() override {
        egl()->make_current(display_, nullptr, nullptr, nullptr);
        egl()->destroy_context(display_, context_);  // the display is shared by the process and stays
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    GlProc get_proc_address(const char* name) const override {
        return reinterpret_cast<GlProc>(egl()->get_proc_address(name));
    }
    std::string kind() const override { return "egl"; }

private:
    EGLDisplay display_;
    EGLContext context_;
};

std::unique_ptr<GlContext> context_on(EGLDisplay display) {
    const Egl& e = *egl();
    if (display == nullptr || !e.initialize(display, nullptr, nullptr) || !e.bind_api(kOpenglApi)) return nullptr;
    const std::array<EGLint, 5> wanted = {kRenderableType, kOpenglBit, kSurfaceType, 0, kNone};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!e.choose_config(display, wanted.data(), &config, 1, &count) || count < 1) return nullptr;
    const std::array<EGLint, 7> attributes = {kMajorVersion, 3, kMinorVersion, 3, kProfileMask, kCoreProfileBit, kNone};
    EGLContext context = e.create_context(display, config, nullptr, attributes.data());
    if (context == nullptr) return nullptr;
    auto result = std::make_unique<EglContext>(display, context);
    if (!e.make_current(display, nullptr, nullptr, context)) return nullptr;
    return result;
}

}  // namespace

Result<std::unique_ptr<GlContext>> make_egl_context() {
    const Egl* e = egl();
    if (e == nullptr)
        return failed("EGL: libEGL.so.1 is not installed (Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri)");
    const char* extensions = e->query_string(nullptr, kExtensions);
    const auto has = [&](const char* name) {
        return extensions != nullptr && std::strstr(extensions, name) != nullptr;
    };
    if (e->get_platform_display != nullptr && e->query_devices != nullptr && has("EGL_EXT_platform_device")) {
        std::array<EGLDevice, 16> devices{};
        EGLint count = 0;
        if (e->query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count))
            for (EGLint i = 0; i < count; ++i)
                if (auto context = context_on(
                        e->get_platform_display(kPlatformDevice, devices[static_cast<std::size_t>(i)], nullptr)))
                    return context;
    }
    if (e->get_platform_display != nullptr && has("EGL_MESA_platform_surfaceless"))
        if (auto context = context_on(e->get_platform_display(kPlatformSurfaceless, nullptr, nullptr))) return context;
    if (auto context = context_on(e->get_display(nullptr))) return context;
    return failed(
        "EGL: no device gives an OpenGL 3.3 core context (Debian and Ubuntu: apt install libgl1-mesa-dri for software "
        "rendering)");
}

}  // namespace nullscope
