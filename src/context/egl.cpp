// EGL: every device of EGL_EXT_platform_device in turn, then Mesa's surfaceless platform, then the default display.

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "context/context.h"
#include "platform/library.h"

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
constexpr EGLint kDrmDeviceFile = 0x3233;

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
    const char* (*query_device_string)(EGLDevice, EGLint) = nullptr;
};

const Egl* egl() {
    static Egl e;
    static const bool ok = [] {
        void* library = platform::open_library({"libEGL.so.1", "libEGL.so"});
        if (library == nullptr) return false;
        const bool all = platform::load_symbol(library, "eglGetProcAddress", e.get_proc_address) &&
                         platform::load_symbol(library, "eglGetDisplay", e.get_display) &&
                         platform::load_symbol(library, "eglInitialize", e.initialize) &&
                         platform::load_symbol(library, "eglTerminate", e.terminate) &&
                         platform::load_symbol(library, "eglBindAPI", e.bind_api) &&
                         platform::load_symbol(library, "eglChooseConfig", e.choose_config) &&
                         platform::load_symbol(library, "eglCreateContext", e.create_context) &&
                         platform::load_symbol(library, "eglDestroyContext", e.destroy_context) &&
                         platform::load_symbol(library, "eglMakeCurrent", e.make_current) &&
                         platform::load_symbol(library, "eglQueryString", e.query_string);
        if (!all) return false;
        e.get_platform_display =
            reinterpret_cast<decltype(e.get_platform_display)>(e.get_proc_address("eglGetPlatformDisplayEXT"));
        e.query_devices = reinterpret_cast<decltype(e.query_devices)>(e.get_proc_address("eglQueryDevicesEXT"));
        e.query_device_string =
            reinterpret_cast<decltype(e.query_device_string)>(e.get_proc_address("eglQueryDeviceStringEXT"));
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

Result<std::unique_ptr<GlContext>> context_on(EGLDisplay display) {
    const Egl& e = *egl();
    if (display == nullptr || !e.initialize(display, nullptr, nullptr)) return failed("EGL cannot begin there");
    if (!e.bind_api(kOpenglApi)) return failed("no OpenGL, perhaps OpenGL ES alone");
    const std::array<EGLint, 5> wanted = {kRenderableType, kOpenglBit, kSurfaceType, 0, kNone};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!e.choose_config(display, wanted.data(), &config, 1, &count) || count < 1)
        return failed("no configuration for OpenGL");
    const std::array<EGLint, 7> attributes = {kMajorVersion, 3, kMinorVersion, 3, kProfileMask, kCoreProfileBit, kNone};
    EGLContext context = e.create_context(display, config, nullptr, attributes.data());
    if (context == nullptr) return failed("no OpenGL 3.3 core context");
    auto result = std::make_unique<EglContext>(display, context);
    if (!e.make_current(display, nullptr, nullptr, context)) return failed("the context cannot be made current");
    return std::unique_ptr<GlContext>(std::move(result));
}

bool has_extension(const char* extensions, const char* name) {
    return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

struct EglPlace {
    ContextDevice device;
    unsigned platform;  // 0: the default display's
    EGLDevice native;
};

std::vector<EglPlace> egl_places() {
    const Egl* e = egl();
    if (e == nullptr) return {};
    const char* extensions = e->query_string(nullptr, kExtensions);
    std::vector<EglPlace> places;
    if (e->get_platform_display != nullptr && e->query_devices != nullptr &&
        has_extension(extensions, "EGL_EXT_platform_device")) {
        std::array<EGLDevice, 16> devices{};
        EGLint count = 0;
        if (!e->query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) count = 0;
        for (EGLint i = 0; i < count; ++i) {
            const EGLDevice native = devices[static_cast<std::size_t>(i)];
            const bool asked = e->query_device_string != nullptr;
            const bool has_file =
                asked && has_extension(e->query_device_string(native, kExtensions), "EGL_EXT_device_drm");
            const char* file = has_file ? e->query_device_string(native, kDrmDeviceFile) : nullptr;
            places.push_back(
                {{"egl", fmt::format("device {}", i), file == nullptr ? "" : file}, kPlatformDevice, native});
        }
    }
    if (e->get_platform_display != nullptr && has_extension(extensions, "EGL_MESA_platform_surfaceless"))
        places.push_back({{"egl", "surfaceless", ""}, kPlatformSurfaceless, nullptr});
    places.push_back({{"egl", "default display", ""}, 0, nullptr});
    return places;
}

Result<std::unique_ptr<GlContext>> context_at(const EglPlace& place) {
    return context_on(place.platform == 0 ? egl()->get_display(nullptr)
                                          : egl()->get_platform_display(place.platform, place.native, nullptr));
}

}  // namespace

std::vector<ContextDevice> egl_devices() {
    std::vector<ContextDevice> devices;
    for (EglPlace& place : egl_places()) devices.push_back(std::move(place.device));
    return devices;
}

Result<std::unique_ptr<GlContext>> make_egl_context(std::optional<int> device) {
    if (egl() == nullptr)
        return failed("EGL: libEGL.so.1 is not installed (Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri)");
    const std::vector<EglPlace> places = egl_places();
    if (device) {
        const EglPlace& place = places.at(static_cast<std::size_t>(*device));
        auto context = context_at(place);
        if (!context) return failed(fmt::format("EGL, {}: {}", place.device.place, context.error().what));
        return context;
    }
    for (const EglPlace& place : places)
        if (auto context = context_at(place)) return context;
    return failed(
        "EGL: no device gives an OpenGL 3.3 core context (Debian and Ubuntu: apt install libgl1-mesa-dri for software "
        "rendering)");
}

}  // namespace nullscope
