// nullscope-viewer: curved spacetimes in a window.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "base/atomic_file.h"
#include "base/command_line.h"
#include "base/text.h"
#include "viewer/viewer.h"

namespace {

using namespace nullscope;
using viewer::PixelSize;

constexpr int kLargest = 16384;  // px

int report(const Error& error) {
    const bool input = error.kind == ErrorKind::kBadInput;  // a driver's log may have lines
    fmt::print(stderr, "nullscope-viewer: {}\n", input ? without_controls(error.message) : error.message);
    return static_cast<int>(error.kind);
}

std::optional<PixelSize> parse_size(const std::string& text) {
    const auto parts = split(text, 'x');
    if (parts.size() != 2) return std::nullopt;
    const auto width = parse_number(parts[0]), height = parse_number(parts[1]);
    const auto good = [](const std::optional<double>& n) {
        return n && *n >= 1 && *n <= kLargest && *n == static_cast<int>(*n);
    };
    if (!good(width) || !good(height)) return std::nullopt;
    return PixelSize{static_cast<int>(*width), static_cast<int>(*height)};
}

constexpr const char* kAbout =
    "nullscope-viewer: look at curved spacetimes and fly through them.\n"
    "  nullscope-viewer                                  the first picture\n"
    "  nullscope-viewer near-horizon                     a scene that ships (see: nullscope scenes)\n"
    "  nullscope-viewer my-scene.toml --size 1920x1080   a scene of your own\n"
    "  nullscope-viewer --screenshot window.png          what the window shows, panels too, then quit\n";

constexpr const char* kHands =
    "\nIn the window: drag to look, wheel for the distance, W A S D Space C to fly, Q E to roll, R for the scene's "
    "own\n"
    "camera, H shows the error of every pixel, Tab hides the panels, F1 lists all keys, F12 saves the picture, Escape "
    "quits.\n"
    "Without a display: nullscope capture SCENE -o FILE.png, or xvfb-run nullscope-viewer ...\n"
    "Pictures, films, rays and measurements in files: nullscope (see: nullscope help).";

Command program_of(viewer::ViewerOptions& options, std::string& size) {
    Command program("nullscope-viewer", kAbout);
    program.set_footer(kHands);
    program.set_version(NULLSCOPE_VERSION);
    program.add_option("scene", &options.scene, "Scene file, or the name of one that ships").show_default();
    program.add_option(
        "--size", &size,
        "Window size in pixels, WIDTHxHEIGHT (default: the scene's, or the screen's if that is smaller)");
    program.add_option("--screenshot", &options.screenshot, "Write what the window shows to this .png, then quit");
    program
        .add_option("--after-frames", &options.after_frames,
                    "Quit, and write the screenshot, after this many frames (default: 4 with --screenshot)")
        .in_range(1, 1000000);
    program.add_flag("--hidden", &options.hidden, "Show no window; goes with --screenshot or --after-frames");
    program.add_flag("--one-context", &options.one_context,
                     "Draw pictures where the panels are drawn, not in the background");
    program.add_option("--turns", &options.turns,
                       "Write what the window's loop does to this file: the first pictures with the time since the "
                       "start, turns with their processor time, when it rests (/dev/stderr: to the terminal)");
    return program;
}

int run(const viewer::ViewerOptions& options) {
    auto opened = viewer::Viewer::open(options);
    if (!opened) return report(opened.error());
    if (Status done = (*opened)->run(); !done) return report(done.error());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    nullscope::clean_up_on_signals();
    constexpr int kFramesOfScreenshot = 4;  // panels have found their size by then
    viewer::ViewerOptions options;
    std::string size;
    const auto asked = nullscope::parse_command_line(program_of(options, size), argc, argv);
    if (!asked) return report(asked.error());
    if (!asked->text.empty()) return fmt::print("{}", asked->text), 0;
    if (!size.empty()) {
        options.size = parse_size(size);
        if (!options.size)
            return report(
                bad_input(fmt::format("--size {}: not a size; allowed: WIDTHxHEIGHT, whole numbers from 1x1 to {}x{}",
                                      size, kLargest, kLargest)));
    }
    if (!options.screenshot.empty()) {
        if (!options.screenshot.ends_with(".png"))
            return report(bad_input(fmt::format(
                "--screenshot {}: unknown kind of file; allowed: names that end in .png", options.screenshot)));
        if (options.after_frames == 0) options.after_frames = kFramesOfScreenshot;
    }
    if (options.hidden && options.after_frames == 0)
        return report(
            bad_input("--hidden alone would run unseen for ever; add --screenshot FILE.png or --after-frames N"));
    try {
        return run(options);
    } catch (const std::bad_alloc&) {
        return report(failed("out of memory"));
    } catch (const std::exception& e) {
        return report(failed(e.what()));
    }
}
