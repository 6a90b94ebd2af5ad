#include "studio/user_files.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>

#include "base/atomic_file.h"
#include "base/text.h"
#include "platform/places.h"

namespace nullscope::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSettings = 1u << 14;  // bytes: no depth of tables is dangerous in so few
constexpr int kLargestWindow = 16384;               // px

fs::path settings_file() {
    const fs::path folder = config_folder();
    return folder.empty() ? folder : folder / "viewer.toml";
}

Settings read(const toml::table& root) {
    Settings settings;
    settings.hints_seen = root["hints_seen"].value_exact<bool>().value_or(settings.hints_seen);
    settings.light_theme = root["theme"].value_exact<std::string>() == "light";
    const auto unit = std::ranges::find(kLengthUnitNames, root["units"].value_or(std::string()));
    if (unit != std::end(kLengthUnitNames))
        settings.numbers.unit = static_cast<LengthUnit>(unit - std::begin(kLengthUnitNames));
    const double suns = root["mass_suns"].value_or(settings.numbers.mass_suns);
    if (suns >= kLeastMass_suns && suns <= kMostMass_suns) settings.numbers.mass_suns = suns;
    settings.numbers.decimal_comma = root["decimal_comma"].value_exact<bool>().value_or(false);
    const double scale = root["text_scale"].value_or(settings.text_scale);
    if (scale >= kLeastTextScale && scale <= kMostTextScale) settings.text_scale = scale;
    const long width = root["window"][0].value_or(0L), height = root["window"][1].value_or(0L);
    if (std::min(width, height) > 0 && std::max(width, height) <= kLargestWindow)
        settings.width = static_cast<int>(width), settings.height = static_cast<int>(height);
    const auto x = root["window_place"][0].value<int>(), y = root["window_place"][1].value<int>();
    if (x && y) settings.place = ScreenPlace{*x, *y};
    if (const toml::array* recent = root["recent"].as_array())
        for (const toml::node& file : *recent)
            if (auto path = file.value<std::string>(); path && !path->empty() && *path == without_controls(*path) &&
                                                       settings.recent.size() < Settings::kMostRecent)
                settings.recent.push_back(std::move(*path));
    return settings;
}

}  // namespace

fs::path config_folder() { return platform::settings_folder(); }
fs::path state_folder() { return platform::state_folder(); }

Settings load_settings() {
    const fs::path file = settings_file();
    std::error_code error;
    if (file.empty() || !fs::is_regular_file(file, error)) return {};
    const Result<std::string> text = read_text(file, kLargestSettings);
    if (!text) return {};
    try {
        return read(toml::parse(*text));
    } catch (const toml::parse_error&) {
        return {};
    }
}

Status save_settings(const Settings& settings) {
    const fs::path file = settings_file();
    if (file.empty()) return Done{};
    std::error_code error;
    fs::create_directories(file.parent_path(), error);  // if it fails, writing says so
    toml::array recent;
    for (const std::string& path : settings.recent) recent.push_back(path);
    toml::table root{{"hints_seen", settings.hints_seen},
                     {"text_scale", settings.text_scale},
                     {"theme", settings.light_theme ? "light" : "dark"},
                     {"units", kLengthUnitNames[static_cast<std::size_t>(settings.numbers.unit)]},
                     {"mass_suns", settings.numbers.mass_suns},
                     {"decimal_comma", settings.numbers.decimal_comma},
                     {"recent", recent}};
    if (settings.width > 0) root.insert("window", toml::array{settings.width, settings.height});
    if (settings.place) root.insert("window_place", toml::array{settings.place->x, settings.place->y});
    std::ostringstream text;
    text << root << '\n';
    return write_text_atomically(file, text.str());
}

Status KeptSettings::keep() {
    if (now == in_file_) return Done{};
    in_file_ = now;
    return save_settings(now);
}

}  // namespace nullscope::viewer
