#include "scenefile/tour_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/text.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_value.h"
#include "scenefile/toml_text.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestLine = 200;  // bytes, of title and description
constexpr std::string_view kSceneWords = "the name of a scene that ships, or a scene file relative to this one";
constexpr std::string_view kStepsWords = "1 to 100 sections [[step]]";

int tour_line_of(const toml::key& key) { return static_cast<int>(key.source().begin.line); }
int tour_line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

// Lines of a paragraph are joined; a blank line ends it.
std::string paragraphs_of(std::string_view text) {
    std::string joined;
    bool ends = false;
    for (const std::string& raw : split(text, '\n')) {
        const std::string line = without_controls(trim(raw));
        if (!line.empty() && !joined.empty()) joined += ends ? '\n' : ' ';
        joined += line;
        ends = line.empty();
    }
    return joined;
}

// Effects of a scene that can go alone.
std::vector<std::string> switches_of(const Scene& scene) {
    std::vector<std::string> words;
    for (const EffectReason& reason : required_effects(scene))
        if (without_effect(scene, reason.effect)) words.emplace_back(effect_row(reason.effect).key);
    return words;
}

class TourReader {
public:
    TourReader(const std::string& label, fs::path base) : label_(label), base_(std::move(base)) {}
    Result<Tour> read(const toml::table& root);

private:
    void read_steps(const toml::node& node, int line);
    void read_step(const toml::table& table, const std::string& label);
    void read_place(const toml::table& table, const std::string& label, TourStep& step);
    void read_off(const toml::node& node, const std::string& name, const Scene& scene, EffectSet& off);
    const Result<Scene>& scene_of(const std::string& place);
    // The text of a key; "" where it is missing or wrong, and reported.
    std::string words(const toml::table& table, int line, const std::string& prefix, std::string_view key,
                      std::size_t most);
    void report_unknown(const toml::table& table, const std::string& prefix, const std::vector<std::string>& known);
    void report(int line, std::string name, std::string what, std::string_view allowed);

    std::string label_;
    fs::path base_;
    Tour tour_;
    std::map<std::string, Result<Scene>> scenes_;
    std::map<int, Error> reports_;  // what is wrong, by line; the first is returned
};

void TourReader::report(int line, std::string name, std::string what, std::string_view allowed) {
    reports_.emplace(line,
                     Error{ErrorKind::kBadInput, std::move(what), std::string(allowed), std::move(name), label_, line});
}

void TourReader::report_unknown(const toml::table& table, const std::string& prefix,
                                const std::vector<std::string>& known) {
    for (const auto& [name, node] : table) {
        if (std::ranges::find(known, name.str()) != known.end()) continue;
        const std::string nearest = nearest_word(name.str(), known), quoted = in_quotes(name.str());
        report(tour_line_of(name), prefix + quoted.substr(1, quoted.size() - 2), "unknown key",
               fmt::format("{}{}", fmt::join(known, ", "),
                           nearest.empty() ? "" : fmt::format(" (nearest known key: {})", nearest)));
    }
}

std::string TourReader::words(const toml::table& table, int line, const std::string& prefix, std::string_view key,
                              std::size_t most) {
    const std::string name = fmt::format("{}{}", prefix, key), allowed = fmt::format("text of 1 to {} bytes", most);
    const auto found = table.find(key);
    if (found == table.end()) return report(line, name, "missing", allowed), "";
    const toml::value<std::string>* text = found->second.as_string();
    const int at = tour_line_of(found->first);
    if (text == nullptr) return report(at, name, "must be a string", allowed), "";
    if (text->get().size() > most) return report(at, name, fmt::format("{} bytes", text->get().size()), allowed), "";
    if (trim(text->get()).empty()) return report(at, name, "is empty", allowed), "";
    return text->get();
}

const Result<Scene>& TourReader::scene_of(const std::string& place) {
    const auto found = scenes_.find(place);
    return found != scenes_.end() ? found->second : scenes_.emplace(place, load_scene(place)).first->second;
}

void TourReader::read_off(const toml::node& node, const std::string& name, const Scene& scene, EffectSet& off) {
    const std::vector<std::string> known = switches_of(scene);
    const std::string allowed =
        known.empty() ? "nothing: no effect of this scene can go alone" : fmt::format("{}", fmt::join(known, ", "));
    const toml::array* list = node.as_array();
    if (list == nullptr) return report(tour_line_of(node), name, "must be a list of effects", allowed);
    for (const toml::node& entry : *list) {
        const auto* word = entry.as_string();
        if (word == nullptr || std::ranges::find(known, word->get()) == known.end()) {
            const std::string shown = word == nullptr ? "an entry that is not a string" : in_quotes(word->get());
            return report(tour_line_of(entry), name,
                          shown + " is no effect that this step's scene has and can go without", allowed);
        }
        for (const EffectRow* row : effect_rows())
            if (row->key == word->get()) off.insert(row->effect);
    }
}

// What a step shows: scene, view and effects, which are checked together.
void TourReader::read_place(const toml::table& table, const std::string& label, TourStep& step) {
    const auto at = table.find("scene");
    const bool named = step.scene.find('/') == std::string::npos && !step.scene.ends_with(".toml");
    if (!named) step.scene = (base_ / step.scene).string();
    const Result<Scene>& loaded = scene_of(step.scene);
    if (!loaded) return report(tour_line_of(at->first), label + "scene", loaded.error().message(), kSceneWords);
    Scene scene = *loaded;
    if (const auto view = table.find("view"); view != table.end()) {
        const auto* line = view->second.as_string();
        auto camera = camera_of_view(line != nullptr ? line->get() : "", scene);
        if (!camera) {
            const Error& error = camera.error();
            const std::string what = error.key.empty() ? error.what : fmt::format("{}: {}", error.key, error.what);
            return report(tour_line_of(view->first), label + "view", what, error.allowed);
        }
        step.view = scene.camera = *camera;
    }
    if (const auto off = table.find("off"); off != table.end()) read_off(off->second, label + "off", scene, step.off);
}

void TourReader::read_step(const toml::table& table, const std::string& label) {
    constexpr std::size_t kLongestPath = 4096;
    const int line = std::max(tour_line_of(table), 1);
    report_unknown(table, label, {"scene", "view", "off", "text"});
    TourStep step;
    step.text = paragraphs_of(words(table, line, label, "text", kLongestTourText));
    step.scene = words(table, line, label, "scene", kLongestPath);
    if (!step.scene.empty()) read_place(table, label, step);
    tour_.steps.push_back(std::move(step));
}

void TourReader::read_steps(const toml::node& node, int line) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty() || !list->is_array_of_tables())
        return report(line, "step", "must be a list of sections", kStepsWords);
    if (list->size() > kMostTourSteps) return report(line, "step", fmt::format("{} steps", list->size()), kStepsWords);
    for (std::size_t i = 0; i < list->size(); ++i)
        read_step(*list->get_as<toml::table>(i), fmt::format("step[{}].", i + 1));
}

Result<Tour> TourReader::read(const toml::table& root) {
    report_unknown(root, "", {"title", "description", "step"});
    tour_.title = without_controls(words(root, 1, "", "title", kLongestLine));
    tour_.description = without_controls(words(root, 1, "", "description", kLongestLine));
    if (const auto steps = root.find("step"); steps != root.end())
        read_steps(steps->second, std::max(tour_line_of(steps->first), 1));
    else
        report(1, "step", "missing", kStepsWords);
    if (reports_.empty()) return tour_;
    return without_controls(reports_.begin()->second);
}

}  // namespace

Result<Tour> parse_tour(std::string_view toml_text, const std::string& file_label, const fs::path& base_directory) {
    TRY(root, toml_of(toml_text, file_label));
    return TourReader(file_label, base_directory).read(*root);
}

bool is_tour_file(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    const auto text = read_text(file, kLargestSceneFile);
    if (!text) return false;
    const auto root = toml_of(*text, "");
    return root && (root->contains("step") || root->contains("title"));
}

Result<Tour> load_tour(const fs::path& file) {
    const Result<std::string> text = read_text(file, kLargestSceneFile);
    if (!text) return bad_input(without_controls(text.error().message()));
    return parse_tour(*text, file.string(), file.parent_path());
}

std::vector<TourInfo> shipped_tours() {
    std::vector<TourInfo> tours;
    std::error_code error;
    for (fs::directory_iterator i(assets_directory() / "tours", error), end; !error && i != end; i.increment(error)) {
        if (i->path().extension() != ".toml") continue;
        const Result<Tour> tour = load_tour(i->path());
        tours.push_back(tour ? TourInfo{i->path(), tour->title, tour->description, tour->steps.size()}
                             : TourInfo{i->path(), i->path().stem().string(), tour.error().message(), 0});
    }
    std::ranges::sort(tours, {}, &TourInfo::path);
    return tours;
}

}  // namespace nullscope
