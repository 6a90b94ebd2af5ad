// The viewer's own files in the user's folders, as the XDG base directory specification has them: settings, and scenes that are not saved yet.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "studio/number_words.h"
#include "studio/window_place.h"

namespace nullscope::viewer {

// $XDG_CONFIG_HOME/nullscope or ~/.config/nullscope; $XDG_STATE_HOME/nullscope or ~/.local/state/nullscope. Empty where there is no home.
std::filesystem::path config_folder();
std::filesystem::path state_folder();

struct Settings {
    static constexpr std::size_t kMostRecent = 12;
    bool hints_seen = false;           // those of the first visit
    double text_scale = 1.0;           // 0.75 to 3
    int width = 0, height = 0;         // of the window; 0: none was kept
    std::vector<std::string> recent;   // scene files, the last first
    bool light_theme = false;          // theme = "light", not "dark"
    std::optional<ScreenPlace> place;  // of the window; nothing: none was kept
    NumberStyle numbers;               // units = "r_s", "M" or "km", mass_suns, decimal_comma
    friend bool operator==(const Settings&, const Settings&) = default;
};
inline constexpr double kLeastTextScale = 0.75, kMostTextScale = 3.0;

// Of config_folder()/viewer.toml. What is missing, broken or out of range has its default: nobody shall be kept out by this file.
Settings load_settings();
// Errors: it cannot be written. Writes nothing, without an error, where there is no home.
Status save_settings(const Settings& settings);

// As they are now, and in their file.
class KeptSettings {
public:
    Settings now;
    void load() { now = in_file_ = load_settings(); }
    Status keep();  // writes them if they have changed; errors: as save_settings, once for each change

private:
    Settings in_file_;
};

}  // namespace nullscope::viewer
