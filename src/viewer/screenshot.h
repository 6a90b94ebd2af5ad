// Pictures of the window in files.
#pragma once
#include <filesystem>
#include <functional>

#include "base/image.h"
#include "base/result.h"
#include "viewer/window.h"

namespace nullscope::viewer {

// What `draw` draws to the framebuffer it is given. A window's own framebuffer has no sure content where the window is
// hidden or covered, so it is drawn once more.
Image<unsigned char> drawn_apart(PixelSize size, const std::function<void(unsigned framebuffer)>& draw);

// nullscope-YYYYMMDD-HHMMSS.png in the current folder, absolute; -2, -3 ... before the dot where that exists.
std::filesystem::path fresh_screenshot_path();

}  // namespace nullscope::viewer
