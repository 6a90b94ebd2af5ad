#include "scenefile/scene_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "scene/projection.h"
#include "scenefile/path_values.h"
#include "scenefile/scene_check.h"
#include "scenefile/scene_edit.h"
#include "scenefile/sections.h"
#include "scenefile/toml_text.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

// The shortest decimal number that `read` makes this value of, next to `guess`; without one, the nearest.
template <class Read>
std::optional<std::string> shortest(double value, double guess, Read read) {
    constexpr int kMostDigits = 17;
    for (int digits = 1; digits <= kMostDigits; ++digits) {
        const double rounded = std::stod(fmt::format("{:.{}g}", guess, digits));
        if (read(rounded) == value) return fmt::format("{}", rounded);
    }
    for (const double side : {-INFINITY, INFINITY}) {
        double beside = guess;
        for (int k = 0; k < 3; ++k) {
            beside = std::nextafter(beside, side);
            if (read(beside) == value) return fmt::format("{}", beside);
        }
    }
    return std::nullopt;
}

std::optional<std::string> exact_degrees(double radians) {
    return shortest(radians, radians * 180.0 / std::numbers::pi, [](double d) { return d * std::numbers::pi / 180.0; });
}

std::string exact_angle_text(double radians) {
    const auto degrees = exact_degrees(radians);
    return degrees ? *degrees : toml_string(fmt::format("{} rad", radians));
}

// A pinhole's: if a number of degrees gives it. exact: else that number may be off by a rounding.
std::optional<std::string> fov_text(const CameraSpec& camera, bool exact) {
    if (!projection_of(camera).flat)
        return exact ? exact_angle_text(camera.plane_width) : degrees_text(camera.plane_width);
    return shortest(camera.plane_width, 2.0 * std::atan(0.5 * camera.plane_width) * 180.0 / std::numbers::pi,
                    [](double d) { return 2.0 * std::tan(0.5 * (d * std::numbers::pi / 180.0)); });
}

std::string path_text(const fs::path& path, const fs::path& base) {
    if (path.empty()) return toml_string("");
    const std::string whole = path.string(), folder = base.string() + '/';
    return toml_string(!base.empty() && whole.starts_with(folder) ? whole.substr(folder.size())
                                                                  : fs::absolute(path).string());
}

// How a text is written, for whom.
struct Written {
    fs::path base{};
    const SceneFolders* folders = nullptr;  // of a picture
    bool exact = false;
    std::string path(const fs::path& path) const {
        return folders != nullptr ? toml_string(path_in(*folders, path)) : path_text(path, base);
    }
    std::string angle(double radians) const { return exact ? exact_angle_text(radians) : degrees_text(radians); }
};

std::string value_text(const SceneKey& key, const KeyValue& value, const Written& as) {
    switch (key.type) {
        case KeyType::kNumber: return key.unit == "deg" ? as.angle(value.number) : fmt::format("{}", value.number);
        case KeyType::kNumbers:
            return value.numbers.size() == 1 ? fmt::format("{}", value.numbers.front())
                                             : fmt::format("[{}]", fmt::join(value.numbers, ", "));
        case KeyType::kVelocity:
        case KeyType::kPoint:
        case KeyType::kColour: return fmt::format("[{}, {}, {}]", value.vector.x, value.vector.y, value.vector.z);
        case KeyType::kWhole: return fmt::format("{}", value.width);
        case KeyType::kSize: return fmt::format("[{}, {}]", value.width, value.height);
        case KeyType::kChoice: return toml_string(split(key.choices, ' ')[static_cast<std::size_t>(value.choice)]);
        case KeyType::kFile: return as.path(value.path);
        case KeyType::kText:
        case KeyType::kMetric:
        case KeyType::kFormula: break;
    }
    return toml_string(value.text);
}

class Writer {
public:
    std::string view() {
        Scene blank;
        if (scene_.camera.zoom) blank.camera.zoom.emplace();
        const auto inside = [&](std::string_view section) {
            std::string line = lines(section, scene_, blank, false);
            for (std::size_t at = line.find('\n'); at != std::string::npos; at = line.find('\n', at))
                line.replace(at, 1, at + 1 == line.size() ? "" : ", ");
            return line;
        };
        const auto table = [](std::string_view name, const std::string& inner) {
            return inner.empty() ? fmt::format("{} = {{}}", name) : fmt::format("{} = {{ {} }}", name, inner);
        };
        std::string camera = inside("camera");
        if (scene_.camera.zoom) camera += (camera.empty() ? "" : ", ") + table("zoom", inside("zoom"));
        return table("camera", camera);
    }
    Writer(const Scene& scene, Written as) : scene_(scene), as_(std::move(as)) {
        const auto has_fov = [](const CameraSpec& camera) {
            return camera.focal_distance == 1.0 && fov_text(camera, false).has_value();
        };
        by_fov_ =
            has_fov(scene.camera) && (!scene.path || std::ranges::all_of(scene.path->keys, has_fov, &PathKey::camera));
    }
    std::string text() {
        for_each_section(scene_, [this](const Section& section, const std::string&, const Scene& holder) {
            add_section(section, holder);
            if (!section.inner.empty()) add_path_keys();
        });
        return text_;
    }

    const std::vector<std::pair<std::string, fs::path>>& files() const { return files_; }

private:
    // Its lines where they differ from what `before` has.
    std::string lines(std::string_view section, const Scene& holder, const Scene& before, bool words) {
        std::string lines;
        bool by_angle = false;
        for (const SceneKey& key : keys_of(section)) {
            if (key.meant != nullptr && !key.meant(holder)) continue;
            if (by_fov_ && full_name(key) == "camera.fov" && holder.camera.focal_distance == 1.0 &&
                (holder.camera.plane_width != before.camera.plane_width || before.camera.focal_distance != 1.0))
                if (const auto fov = fov_text(holder.camera, as_.exact)) {
                    lines += fmt::format("fov = {}\n", *fov), by_angle = true;
                    continue;
                }
            if (!key.member.readable() || (by_angle && (key.key == "plane_width" || key.key == "focal_distance")))
                continue;
            const KeyValue value = key.member.get(holder);
            const std::string text = value_text(key, value, as_);
            const bool word = words && key.type == KeyType::kChoice;  // `before` has taken it over
            const bool is_default =
                word ? text == toml_string(key.fallback) : text == value_text(key, key.member.get(before), as_);
            if (!value.there || (is_default && !key.needed)) continue;
            lines += fmt::format("{} = {}\n", key.key, text);
            if (key.type == KeyType::kFile && !value.path.empty()) add_file(value.path);
        }
        return lines;
    }

    void add_file(const fs::path& file) {
        if (as_.folders != nullptr &&
            std::ranges::find(files_, file, &std::pair<std::string, fs::path>::second) == files_.end())
            files_.emplace_back(path_in(*as_.folders, file), file);
    }

    // All that are given: those that have their default's value say so.
    std::string parameters(const SpacetimeSpec& spec) const {
        std::string lines;
        for (const auto& [name, value] : spec.parameters) lines += fmt::format("{} = {}\n", name, value);
        for (const auto& [name, formula] : spec.parameters.formulas)
            lines += fmt::format("{} = {}\n", name, toml_string(formula));
        return lines;
    }

    void add(std::string_view head, const std::string& lines) {
        if (!text_.empty()) text_ += '\n';
        text_ += fmt::format("{}\n{}", head, lines);
    }

    void add_section(const Section& section, const Scene& holder) {
        std::string found = lines(section.name, holder, section_defaults(holder, section.name), true);
        if (section.spacetime) found += parameters(section.spacetime.of(holder));
        if (section.name.empty()) {
            text_ = found;
            return;
        }
        if (found.empty() && !section.optional()) return;
        const bool several = count_of(scene_, section) > 1;
        add(several ? fmt::format("[[{}]]", section.name) : fmt::format("[{}]", section.name), found);
    }

    // What a key leaves out is as in the one before it, and as in [camera] in the first.
    void add_path_keys() {
        Scene before = scene_;
        double time_before = 0.0;
        std::vector<double> values_before;
        for (const PathKey& key : scene_.path->keys) {
            Scene here = scene_;
            here.camera = key.camera;
            const std::string time = key.time != time_before ? fmt::format("time = {}\n", key.time) : "";
            std::string zoom;
            if (here.camera.zoom) {
                if (!before.camera.zoom) before.camera.zoom.emplace();
                zoom = lines("zoom", here, before, false);
            }
            const std::string camera = lines("camera", here, before, false);
            const std::string set = path_values(key, values_before);
            add("[[path.key]]", fmt::format("frame = {}\n{}{}{}{}", key.frame, time, camera, zoom, set));
            before.camera = key.camera, time_before = key.time, values_before = key.values;
        }
    }

    // Of the first key all.
    std::string path_values(const PathKey& key, const std::vector<double>& before) const {
        std::vector<std::string> words;
        for (std::size_t i = 0; i < key.values.size(); ++i) {
            const std::string& name = scene_.path->keyed[i];
            const auto value = path_value(scene_, name);
            if (!value || (!before.empty() && before[i] == key.values[i])) continue;
            KeyValue number;
            number.number = key.values[i];
            words.push_back(fmt::format("{} = {}", toml_string(name), value_text(value->key, number, as_)));
        }
        return words.empty() ? "" : fmt::format("set = {{ {} }}\n", fmt::join(words, ", "));
    }

    const Scene& scene_;
    Written as_;
    std::vector<std::pair<std::string, fs::path>> files_;
    bool by_fov_ = true;  // else by plane_width and focal_distance, throughout: a file may not have both
    std::string text_;
};

// In quotes where it is no bare word.
std::string inline_key(std::string_view key) {
    const auto bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
    return std::ranges::all_of(key, bare) ? std::string(key) : toml_string(std::string(key));
}

// As inline tables have it; numbers in the fewest digits that read back as the same, on every platform.
std::string inline_text(const toml::node& node) {
    std::vector<std::string> parts;
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            parts.push_back(fmt::format("{} = {}", inline_key(key.str()), inline_text(value)));
        return fmt::format("{{ {} }}", fmt::join(parts, ", "));
    }
    if (const toml::array* array = node.as_array()) {
        for (const toml::node& value : *array) parts.push_back(inline_text(value));
        return fmt::format("[{}]", fmt::join(parts, ", "));
    }
    if (const auto text = node.value_exact<std::string>()) return toml_string(*text);
    if (const auto whole = node.value_exact<std::int64_t>()) return fmt::format("{}", *whole);
    return fmt::format("{}", node.value_or(0.0));
}

}  // namespace

// What a file says that has these sections and nothing in them but the words that defaults depend on.
Scene section_defaults(const Scene& holder, std::string_view section) {
    Scene blank;
    for (const Section& each : sections())
        for (std::size_t i = 0; each.optional() && i < count_of(holder, each); ++i) each.add(blank);
    if (holder.path) blank.path->keys = holder.path->keys;
    for (const SceneKey& key : keys_of(section))
        if (key.type == KeyType::kChoice && key.member.readable()) key.member.set(blank, key.member.get(holder));
    settle_size(blank, [](const std::string&) { return false; });
    settle_defaults(blank, [](const std::string&) { return false; });
    return blank;
}

std::string degrees_text(double radians) {
    const auto read = [](double d) { return d * std::numbers::pi / 180.0; };
    const double guess = radians * 180.0 / std::numbers::pi;
    if (const auto text = exact_degrees(radians)) return *text;
    return shortest(read(guess), guess, read).value_or(fmt::format("{}", guess));
}

std::string field_of_view_text(const CameraSpec& camera) {
    const auto exact = fov_text(camera, false);
    return exact ? *exact : degrees_text(field_of_view(camera));
}

std::string scene_file_text(const Scene& scene, const fs::path& base_directory) {
    return Writer(scene, {base_directory}).text();
}

std::string exact_scene_text(const Scene& scene, const fs::path& base_directory) {
    return Writer(scene, {base_directory, nullptr, true}).text();
}

WrittenScene written_scene(const Scene& scene, const SceneFolders& folders) {
    Writer writer(scene, {{}, &folders, true});
    std::string text = writer.text();
    return {std::move(text), writer.files()};
}

std::string path_in(const SceneFolders& folders, const fs::path& path) {
    std::string whole = path.string();
    for (const fs::path& folder : folders)
        if (const std::string start = folder.string() + '/'; !folder.empty() && whole.starts_with(start))
            return whole.substr(start.size());
    return whole;
}

std::string scene_line(const Scene& scene) {
    auto text = toml_of(scene_file_text(scene, {}), "scene");
    if (!text) return "";  // larger than a scene file may be
    return "scene = " + inline_text(*text);
}

std::string view_line(const CameraSpec& camera) {
    Scene scene;
    scene.camera = camera;
    scene.camera.width = CameraSpec{}.width, scene.camera.height = CameraSpec{}.height;
    return Writer(scene, {}).view();
}

}  // namespace nullscope
