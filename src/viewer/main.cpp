// nullscope-viewer: curved spacetimes in a window.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string>
#include <string_view>

#include "base/atomic_file.h"
#include "base/command_line.h"
#include "base/manual.h"
#include "base/text.h"
#include "gl/driver_death.h"
#include "platform/console.h"
#include "platform/endings.h"
#include "platform/failure_box.h"
#include "version/version.h"
#include "viewer/panel.h"
#include "viewer/viewer.h"

namespace {

using namespace nullscope;

constexpr int kLargest = 16384;  // px

int report(const Error& error) {
    const bool input = error.kind == ErrorKind::kBadInput;  // a driver's log may have lines
    const std::string words = input ? without_controls(error.message()) : error.message();
    fmt::print(stderr, "nullscope-viewer: {}\n", words);
    platform::show_failure("nullscope-viewer", words);
    return static_cast<int>(error.kind);
}

constexpr const char* kAbout =
    "nullscope-viewer: fly through curved spacetimes.\n  nullscope-viewer                                  the gallery "
    "of scenes\n  nullscope-viewer near-horizon                     a built-in scene (see: nullscope "
    "scenes)\n  nullscope-viewer my-scene.toml --size 1920x1080   a scene of your own\n  nullscope-viewer --screenshot "
    "window.png          save what the window shows, with panels, then quit\n";

constexpr const char* kSceneNames = "nullscope scenes | cut -d\" \" -f1";  // for completion

constexpr const char* kControls =
    "\nIn the window: drag to look around, wheel for the distance, Z and wheel\nto zoom into the photon ring, W A S D "
    "Space C to fly, Q E to roll, R returns to "
    "the\nscene's camera, H shows the error of every pixel, O colours image orders, Ctrl+Tab enters the panels\nby "
    "keyboard, Ctrl+O "
    "opens the gallery,\nCtrl+S saves the scene, Ctrl+Z undoes, "
    "F12 saves the picture, Ctrl+Q quits. Without a display: "
    "nullscope capture SCENE -o FILE.png, or xvfb-run nullscope-viewer "
    "...\nFor pictures, films, rays and measurements in files, use nullscope (see: nullscope help).";

constexpr std::string_view kShaders[] = {"auto", "measured", "fragment", "compute"};  // in the order of StageWish

struct Words {
    std::string size, manual, shaders = "auto";
};

Command program_of(viewer::ViewerOptions& options, Words& words) {
    Command program("nullscope-viewer", kAbout);
    program.set_footer(kControls + ("\n\nPanels, of the menus View and Help:\n" + viewer::panel_help()));
    program.set_version(kVersionText);
    program.add_option("scene", &options.scene, "Scene file, or the name of a built-in scene (default: the gallery)");
    program.add_flag("--gallery", &options.gallery, "Start with the gallery, before the scene");
    program.add_option(
        "--size", &words.size,
        "Window size in pixels, WIDTHxHEIGHT (default: the scene's, or the screen's if that is smaller)");
    program.add_option("--screenshot", &options.screenshot, "Write what the window shows to this .png, then quit");
    program
        .add_option("--after-frames", &options.after_frames,
                    "Write the screenshot and quit after this many frames (default: 4 with --screenshot)")
        .in_range(1, 1000000);
    program.add_flag("--hidden", &options.hidden, "Show no window; use with --screenshot or --after-frames");
    program.add_flag("--one-context", &options.one_context,
                     "Draw pictures in the window's own OpenGL context, not in a background thread");
    program
        .add_option("--shaders", &words.shaders,
                    "What traces pictures, which are the same: fragment, compute (OpenGL 4.3), auto: what takes less, "
                    "timed at rest once for each kind of scene, or measured: the same where the processor draws, too")
        .one_of({std::begin(kShaders), std::end(kShaders)});
    program
        .add_option("--coarse", &options.coarse,
                    "Render at 1/N of the window's resolution in each direction, for slow machines with "
                    "large screens (default: 1)")
        .in_range(1, 16);
    program.add_option("--turns", &options.turns,
                       "Log the window's event loop to this file: times of the first pictures, iterations with their "
                       "processor time, when it is idle (/dev/stderr: to the terminal)");
    program.add_option("--layout", &options.layout,
                       "Write the positions of the panels' texts to this file whenever the window is idle, with those "
                       "that are cut off or overlap");
    program.add_option("--manual", &words.manual,
                       "Write the man page and a bash completion script into this folder, then quit");
    return program;
}

}  // namespace

int main(int argc, char** argv) {
    nullscope::platform::begin_console();
    nullscope::clean_up_on_signals();
    nullscope::gl::name_driver_at_death("nullscope-viewer");
    constexpr int kFramesOfScreenshot = 4;  // panels have found their size by then
    viewer::ViewerOptions options;
    Words words;
    const Command program = program_of(options, words);
    const auto asked = nullscope::parse_command_line(program, argc, argv);
    if (!asked) return report(asked.error());
    if (!asked->text.empty()) return fmt::print("{}", asked->text), 0;
    if (!words.manual.empty()) {
        const Status written = write_manual(program, kSceneNames, words.manual);
        return written ? 0 : report(written.error());
    }
    if (!words.size.empty()) {
        const auto sides = two_whole_numbers(words.size, 'x', 1, kLargest);
        if (!sides)
            return report(bad_input(fmt::format("--size {}: not a size", words.size),
                                    fmt::format("WIDTHxHEIGHT, whole numbers from 1x1 to {}x{}", kLargest, kLargest)));
        options.size = viewer::PixelSize{sides->first, sides->second};
    }
    options.stage = static_cast<viewer::StageWish>(std::ranges::find(kShaders, std::string_view(words.shaders)) -
                                                   std::begin(kShaders));
    if (!options.screenshot.empty()) {
        if (!options.screenshot.ends_with(".png"))
            return report(bad_input(fmt::format("--screenshot {}: unknown kind of file", options.screenshot),
                                    "names that end in .png"));
        if (options.after_frames == 0) options.after_frames = kFramesOfScreenshot;
    }
    if (options.hidden && options.after_frames == 0)
        return report(
            bad_input("--hidden alone would run unseen for ever; add --screenshot FILE.png or --after-frames N"));
    try {
        const auto viewer = viewer::Viewer::open(options);
        if (!viewer) return report(viewer.error());
        const Status done = (*viewer)->run();
        const int status = done ? 0 : report(done.error());
        if (!platform::threads_end_together()) platform::end_at_once(status);
        return status;
    } catch (const std::bad_alloc&) {
        return report(failed("out of memory"));
    } catch (const std::exception& e) {
        return report(failed(e.what()));
    }
}
