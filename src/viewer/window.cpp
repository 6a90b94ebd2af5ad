#include "viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <tuple>
#include <vector>

#include "gl/gl.h"

namespace nullscope::viewer {
namespace {

static_assert(GLFW_KEY_LAST < Input::kKeys);

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason given" : text;
}

std::string no_display() {
    const char* x11 = std::getenv("DISPLAY");
    const char* wayland = std::getenv("WAYLAND_DISPLAY");
    std::string why = "DISPLAY is not set";
    if (x11 != nullptr && *x11 != '\0')
        why = fmt::format("nothing answers at DISPLAY={}", x11);
    else if (wayland != nullptr && *wayland != '\0')
        why = last_glfw_error();
    return fmt::format("no display could be opened ({}); use `nullscope capture` or xvfb-run", why);
}

void ask_for_core_context() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

// Called when there is no 3.3 core context: says which OpenGL there is instead.
std::string no_opengl() {
    constexpr unsigned kGlRenderer = 0x1F01;  // GL_RENDERER
    const std::string reason = last_glfw_error();
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    std::string found = fmt::format("none could be had here ({})", reason);
    if (GLFWwindow* plain = glfwCreateWindow(64, 64, "", nullptr, nullptr)) {
        glfwMakeContextCurrent(plain);
        using GetString = const unsigned char* (*)(unsigned);
        const auto get_string = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
        const unsigned char* renderer = get_string == nullptr ? nullptr : get_string(kGlRenderer);
        found = fmt::format("this driver has {}.{} ({})", glfwGetWindowAttrib(plain, GLFW_CONTEXT_VERSION_MAJOR),
                            glfwGetWindowAttrib(plain, GLFW_CONTEXT_VERSION_MINOR),
                            renderer == nullptr ? "unnamed" : reinterpret_cast<const char*>(renderer));
        glfwDestroyWindow(plain);
    }
    return fmt::format(
        "OpenGL 3.3 core is needed; {}; update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw "
        "with the processor",
        found);
}

// Puts a window that is not shown yet where it can be seen.
void put(GLFWwindow* window, ScreenPlace place) {
    ScreenArea area{place.x, place.y};
    glfwGetWindowSize(window, &area.width, &area.height);
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    std::vector<ScreenArea> areas(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        ScreenArea& room = areas[static_cast<std::size_t>(i)];
        glfwGetMonitorWorkarea(monitors[i], &room.x, &room.y, &room.width, &room.height);
    }
    if (const auto visible = visible_place(area, areas)) glfwSetWindowPos(window, visible->x, visible->y);
}

PixelSize fitted(PixelSize size) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return size;
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    if (width <= 0 || height <= 0) return size;
    return {std::min(size.width, width), std::min(size.height, height)};
}

Input& input_of(GLFWwindow* window) { return *static_cast<Input*>(glfwGetWindowUserPointer(window)); }

void on_key(GLFWwindow* window, int key, int, int action, int mods) {
    Input& input = input_of(window);
    input.happened = true;
    if (key < 0) return;  // a key that GLFW does not know
    const bool control = (mods & GLFW_MOD_CONTROL) != 0;
    input.held[static_cast<std::size_t>(key)] = action != GLFW_RELEASE && !control;
    if (action != GLFW_PRESS) return;
    input.pressed.push_back({key, control, (mods & GLFW_MOD_SHIFT) != 0});
    if (!control) input.tapped[static_cast<std::size_t>(key)] = true;
}

double ratio_of(GLFWwindow* window) {
    int width = 0, height = 0, pixels = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixels, &height);
    return width > 0 ? static_cast<double>(pixels) / width : 1.0;
}

void on_button(GLFWwindow* window, int number, int action, int mods) {
    Input& input = input_of(window);
    input.happened = true;
    if (number > GLFW_MOUSE_BUTTON_MIDDLE) return;
    Button& button = number == GLFW_MOUSE_BUTTON_LEFT    ? input.left
                     : number == GLFW_MOUSE_BUTTON_RIGHT ? input.right
                                                         : input.middle;
    button.held = action == GLFW_PRESS;
    if (button.held) button.alt = (mods & GLFW_MOD_ALT) != 0;
    button.pressed |= button.held;
    (button.held ? button.pressed_x : button.released_x) = input.x;
    (button.held ? button.pressed_y : button.released_y) = input.y;
}

// glfwGetCursorPos tells where the pointer is by now, not where it was when a button went down.
void on_move(GLFWwindow* window, double x, double y) {
    Input& input = input_of(window);
    const double ratio = ratio_of(window) / input.coarse;
    input.x = ratio * x, input.y = ratio * y;
    input.moved = true;
}

void on_wheel(GLFWwindow* window, double x, double y) {
    Input& input = input_of(window);
    input.happened = true;
    input.wheel += y, input.wheel_sideways += x;
}

// Where there is a display of X11 alone, GLFW 3.4 would ask for one of Wayland first, whose library complains.
void prefer_x11_where_alone() {
#ifdef GLFW_PLATFORM
    if (std::getenv("DISPLAY") != nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

// The first gamepad that is there.
std::optional<PadState> gamepad() {
    for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST; ++id) {
        GLFWgamepadstate state;
        if (glfwGetGamepadState(id, &state) != GLFW_TRUE) continue;
        PadState pad;
        static_assert(std::size(decltype(state.axes){}) == std::tuple_size_v<decltype(pad.axes)>);
        std::ranges::copy(state.axes, pad.axes.begin());
        std::ranges::transform(state.buttons, pad.buttons.begin(),
                               [](unsigned char button) { return button == GLFW_PRESS; });
        return pad;
    }
    return std::nullopt;
}

}  // namespace

double seconds() { return glfwGetTime(); }

Result<std::unique_ptr<Window>> Window::open(PixelSize size, bool fit_to_screen, bool hidden, const std::string& title,
                                             std::optional<ScreenPlace> place, int coarse) {
    prefer_x11_where_alone();
    if (glfwInit() != GLFW_TRUE) return failed(no_display());
    std::unique_ptr<Window> window(new Window);  // from here on its end is GLFW's
    window->input_.coarse = coarse;
    if (fit_to_screen) size = fitted(size);
    ask_for_core_context();
    glfwWindowHint(GLFW_VISIBLE, hidden || place ? GLFW_FALSE : GLFW_TRUE);
    window->handle_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (window->handle_ == nullptr) return failed(no_opengl());
    glfwMakeContextCurrent(window->handle_);
    glfwSwapInterval(1);
    gl::load_functions([](const char* name, void*) { return glfwGetProcAddress(name); }, nullptr);
    constexpr int kLeastWidth = 320, kLeastHeight = 200;
    glfwSetWindowSizeLimits(window->handle_, std::min(kLeastWidth, size.width), std::min(kLeastHeight, size.height),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (place && !hidden) {
        put(window->handle_, *place);
        glfwShowWindow(window->handle_);
    }
    window->listen();
    return window;
}

Window::~Window() {
    if (handle_ != nullptr) glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::listen() {
    glfwSetWindowUserPointer(handle_, &input_);
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(handle_, &x, &y);
    on_move(handle_, x, y);
    glfwSetKeyCallback(handle_, on_key);
    glfwSetMouseButtonCallback(handle_, on_button);
    glfwSetScrollCallback(handle_, on_wheel);
    glfwSetCursorPosCallback(handle_, on_move);
    glfwSetDropCallback(handle_, [](GLFWwindow* w, int count, const char** files) {
        input_of(w).happened = true;
        input_of(w).dropped.insert(input_of(w).dropped.end(), files, files + count);
    });
    glfwSetCursorEnterCallback(handle_, [](GLFWwindow* w, int) { input_of(w).happened = true; });
    glfwSetWindowFocusCallback(handle_, [](GLFWwindow* w, int) { input_of(w).happened = true; });
    glfwSetCharCallback(handle_, [](GLFWwindow* w, unsigned) { input_of(w).happened = true; });
    glfwSetFramebufferSizeCallback(handle_, [](GLFWwindow* w, int, int) { input_of(w).happened = true; });
    glfwSetWindowRefreshCallback(handle_, [](GLFWwindow* w) { input_of(w).happened = true; });
    glfwSetWindowContentScaleCallback(handle_, [](GLFWwindow* w, float, float) { input_of(w).happened = true; });
}

const Input& Window::poll(double wait_s) {
    input_.pressed.clear();
    input_.dropped.clear();
    input_.tapped.reset();
    input_.left.pressed = input_.middle.pressed = input_.right.pressed = input_.happened = input_.moved = false;
    input_.wheel = input_.wheel_sideways = 0.0;
    if (wait_s > 0.0)
        glfwWaitEventsTimeout(wait_s);
    else
        glfwPollEvents();
    input_.shift = input_.held[GLFW_KEY_LEFT_SHIFT] || input_.held[GLFW_KEY_RIGHT_SHIFT];
    listen_to_gamepad();
    return input_;
}

// Of another window's gamepad nothing is taken.
void Window::listen_to_gamepad() {
    const auto pad = glfwGetWindowAttrib(handle_, GLFW_FOCUSED) == GLFW_TRUE ? gamepad() : std::nullopt;
    has_gamepad_ = pad.has_value();
    input_.pad = pad_motion(pad.value_or(PadState{}), pad_);
    pad_ = pad.value_or(PadState{});
    if (input_.pad.reset) input_.pressed.push_back({GLFW_KEY_R, false, false});
    if (input_.pad.close) input_.pressed.push_back({GLFW_KEY_ESCAPE, false, false});
    if (input_.pad.gallery) input_.pressed.push_back({GLFW_KEY_O, true, false});
    input_.happened |= input_.pad.reset || input_.pad.close || input_.pad.gallery;
}

bool Window::is_full_screen() const { return glfwGetWindowMonitor(handle_) != nullptr; }

void Window::toggle_full_screen() {
    if (is_full_screen()) return glfwSetWindowMonitor(handle_, nullptr, left_, top_, width_, height_, GLFW_DONT_CARE);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) return;
    glfwGetWindowPos(handle_, &left_, &top_);
    glfwGetWindowSize(handle_, &width_, &height_);
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::set_icon(int width, int height, const unsigned char* rgba) {
    std::vector<unsigned char> pixels(rgba, rgba + static_cast<std::ptrdiff_t>(width) * height * 4);
    const GLFWimage icon{width, height, pixels.data()};
    glfwSetWindowIcon(handle_, 1, &icon);
}

SharedContext Window::share() {
    ask_for_core_context();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    return SharedContext(glfwCreateWindow(1, 1, "", nullptr, handle_));
}

void ContextEnd::operator()(GLFWwindow* handle) const { glfwDestroyWindow(handle); }
void make_current(const SharedContext& context) {
    glfwMakeContextCurrent(context.get());
    gl::prepare_context();
}
void leave_context() { glfwMakeContextCurrent(nullptr); }

void Window::swap() { glfwSwapBuffers(handle_); }
bool Window::closing() const { return glfwWindowShouldClose(handle_) != 0; }
void Window::close() { glfwSetWindowShouldClose(handle_, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(handle_, title.c_str()); }

PixelSize Window::framebuffer() const {
    PixelSize size;
    glfwGetFramebufferSize(handle_, &size.width, &size.height);
    return size;
}

PixelSize Window::picture() const {
    const PixelSize size = framebuffer();
    const auto part = [this](int side) { return side > 0 ? std::max(side / input_.coarse, 1) : 0; };
    return {part(size.width), part(size.height)};
}

std::optional<ScreenPlace> Window::place() const {
    glfwGetError(nullptr);
    ScreenPlace place;
    glfwGetWindowPos(handle_, &place.x, &place.y);
    if (glfwGetError(nullptr) != GLFW_NO_ERROR) return std::nullopt;
    return place;
}

double Window::pixel_ratio() const { return ratio_of(handle_); }

double Window::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::clamp(static_cast<double>(std::max(x, y)), 0.5, 4.0);
}

}  // namespace nullscope::viewer
