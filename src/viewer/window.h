// The window: GLFW, an OpenGL 3.3 core context whose functions are loaded, and input events since the last poll.
#pragma once
#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "studio/gamepad.h"
#include "studio/window_place.h"

struct GLFWwindow;

namespace nullscope::viewer {

struct PixelSize {
    int width = 0, height = 0;
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

// A mouse button since the last poll, with where it went down and up: the pointer may have moved on since.
struct Button {
    bool pressed = false, held = false;
    bool alt = false;  // was down when it was pressed
    double pressed_x = 0.0, pressed_y = 0.0, released_x = 0.0, released_y = 0.0;
};

// A key that went down, and whether Ctrl and Shift were.
struct KeyPress {
    int key = 0;
    bool control = false, shift = false;
};

// Since the last poll. Keys are GLFW's numbers; positions are the picture's pixels from the top left.
struct Input {
    static constexpr int kKeys = 512;
    std::vector<KeyPress> pressed;    // in order
    std::bitset<kKeys> held, tapped;  // down now; went down, even if up again; both without Ctrl
    Button left, middle, right;
    double x = 0.0, y = 0.0;
    double wheel = 0.0, wheel_sideways = 0.0;
    bool shift = false;
    std::vector<std::string> dropped;  // files
    PadMotion pad;                     // its buttons are among `pressed`, as the keys that mean the same
    bool happened = false;             // anything but mere motion of the pointer
    bool moved = false;
    int coarse = 1;  // framebuffer pixels a pixel of the picture, in each direction
    bool down(int key) const { return held[static_cast<std::size_t>(key)] || tapped[static_cast<std::size_t>(key)]; }
};

// A context without a window that shares textures with the window's; made and destroyed by the main thread, current in one other.
struct ContextEnd {
    void operator()(GLFWwindow* handle) const;
};
using SharedContext = std::unique_ptr<GLFWwindow, ContextEnd>;
void make_current(const SharedContext& context);  // in the calling thread, until it ends or calls leave_context()
void leave_context();

class Window {
public:
    // fit_to_screen: smaller where the screen is smaller. Errors say what is missing and what to do: no display, no OpenGL 3.3.
    // place: where it was the last time; it is moved to where it can be seen. coarse: Input::coarse.
    static Result<std::unique_ptr<Window>> open(PixelSize size, bool fit_to_screen, bool hidden,
                                                const std::string& title, std::optional<ScreenPlace> place = {},
                                                int coarse = 1);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Takes what happened; waits for it up to wait_s seconds if that is above 0.
    const Input& poll(double wait_s);
    void swap();
    bool closing() const;
    void close();
    PixelSize framebuffer() const;             // 0x0 while minimised
    PixelSize picture() const;                 // the framebuffer's size / Input::coarse
    std::optional<ScreenPlace> place() const;  // nothing where the window system does not tell (Wayland)
    double pixel_ratio() const;                // framebuffer pixels a unit of the window's coordinates
    double content_scale() const;              // how much larger than usual things must be drawn, in framebuffer pixels
    void toggle_full_screen();
    bool is_full_screen() const;
    bool has_gamepad() const { return has_gamepad_; }  // to be listened to: it sends no events
    void set_title(const std::string& title);
    void set_icon(int width, int height, const unsigned char* rgba);  // top row first
    SharedContext share();                                            // nullptr where the driver has no second context
    GLFWwindow* handle() const { return handle_; }

private:
    Window() = default;
    void listen();
    GLFWwindow* handle_ = nullptr;
    int left_ = 0, top_ = 0, width_ = 0, height_ = 0;  // of the window, while it is full screen
    void listen_to_gamepad();
    Input input_;
    PadState pad_;
    bool has_gamepad_ = false;
};

double seconds();  // of a steady clock

}  // namespace nullscope::viewer
