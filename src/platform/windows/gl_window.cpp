#include "platform/gl_window.h"

#include <windows.h>

#include <array>
#include <system_error>

namespace nullscope::platform {
namespace {

// The part of WGL_ARB_create_context and its profile that is used here (Khronos registry, wgl.xml).
constexpr int kMajor = 0x2091, kMinor = 0x2092, kProfile = 0x9126, kCoreProfile = 0x0001;
using CreateContext = HGLRC(WINAPI*)(HDC, HGLRC, const int*);

constexpr const wchar_t* kClass = L"nullscope-hidden";

HWND hidden_window() {
    static const ATOM known = [] {
        WNDCLASSW kind{};
        kind.style = CS_OWNDC, kind.lpfnWndProc = ::DefWindowProcW;
        kind.hInstance = ::GetModuleHandleW(nullptr), kind.lpszClassName = kClass;
        return ::RegisterClassW(&kind);
    }();
    if (known == 0) return nullptr;
    return ::CreateWindowExW(0, kClass, L"", WS_OVERLAPPED, 0, 0, 16, 16, nullptr, nullptr, ::GetModuleHandleW(nullptr),
                             nullptr);
}

bool choose_format(HDC device) {
    PIXELFORMATDESCRIPTOR format{};
    format.nSize = sizeof format, format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    format.iPixelType = PFD_TYPE_RGBA, format.cColorBits = 32;
    const int number = ::ChoosePixelFormat(device, &format);
    return number != 0 && ::SetPixelFormat(device, number, &format) != 0;
}

// wglGetProcAddress knows what came after OpenGL 1.1, and says "none" in four other ways too.
void* address_of(const char* name) {
    void* const found = reinterpret_cast<void*>(::wglGetProcAddress(name));
    const auto number = reinterpret_cast<long long>(found);
    if (number > 3 || number < -1) return found;
    return reinterpret_cast<void*>(::GetProcAddress(::GetModuleHandleW(L"opengl32.dll"), name));
}

class WglWindow final : public GlWindow {
public:
    explicit WglWindow(HWND window) : window_(window), device_(::GetDC(window)) {}
    ~WglWindow() override {
        ::wglMakeCurrent(nullptr, nullptr);
        if (context_ != nullptr) ::wglDeleteContext(context_);
        ::ReleaseDC(window_, device_);
        ::DestroyWindow(window_);
    }
    WglWindow(const WglWindow&) = delete;
    WglWindow& operator=(const WglWindow&) = delete;
    void* symbol(const char* name) const override { return address_of(name); }

    // Empty: it is there, and current.
    std::string begin() {
        if (!choose_format(device_)) return "no pixel format for OpenGL";
        // Of OpenGL 1.1, by which the other is had.
        const HGLRC plain = ::wglCreateContext(device_);
        if (plain == nullptr || ::wglMakeCurrent(device_, plain) == 0) return "no context";
        const auto create = reinterpret_cast<CreateContext>(address_of("wglCreateContextAttribsARB"));
        const std::array<int, 7> wanted = {kMajor, 3, kMinor, 3, kProfile, kCoreProfile, 0};
        context_ = create != nullptr ? create(device_, nullptr, wanted.data()) : nullptr;
        ::wglMakeCurrent(nullptr, nullptr);
        ::wglDeleteContext(plain);
        if (context_ == nullptr)
            return "the driver has no OpenGL 3.3 core context (Windows' own has 1.1: install the graphics card's "
                   "driver)";
        return ::wglMakeCurrent(device_, context_) != 0 ? "" : "the context cannot be made current";
    }

private:
    HWND window_;
    HDC device_;
    HGLRC context_ = nullptr;
};

}  // namespace

bool has_gl_windows() { return true; }

std::unique_ptr<GlWindow> make_gl_window(std::string& why) {
    const HWND window = hidden_window();
    if (window == nullptr) {
        why = "no window can be made: " + std::system_category().message(static_cast<int>(::GetLastError()));
        return nullptr;
    }
    auto made = std::make_unique<WglWindow>(window);
    why = made->begin();
    return why.empty() ? std::move(made) : nullptr;
}

}  // namespace nullscope::platform
