#include "scenefile/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/atomic_file.h"
#include "base/text.h"
#include "observer/path.h"
#include "scene/bodies.h"
#include "scenefile/override_table.h"
#include "scenefile/path_csv.h"
#include "scenefile/path_set.h"
#include "scenefile/path_values.h"
#include "scenefile/scene_check.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_value.h"
#include "scenefile/sections.h"
#include "scenefile/toml_text.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

// What files written for older versions may say, and the name that it has now.
struct OldName {
    std::string_view full, now;
};
constexpr OldName kOldNames[] = {{".beside", "split"},
                                 {"sphere.swing", "amplitude"},
                                 {"sky.faintest", "magnitude_limit"},
                                 {"sky.even_stars", "uniform_stars"},
                                 {"path.look", "orientation"}};

std::string_view name_now(std::string_view section, std::string_view name) {
    const auto old = std::ranges::find(kOldNames, fmt::format("{}.{}", section, name), &OldName::full);
    return old != std::end(kOldNames) ? old->now : name;
}

const SceneKey* find_key(std::string_view section, std::string_view name) {
    const auto keys = keys_of(section);
    const auto key = std::ranges::find(keys, name, &SceneKey::key);
    return key != keys.end() ? &*key : nullptr;
}

// The sections that name a metric, and which: null while the file names none that is known.
std::map<std::string, const MetricEntry*, std::less<>> default_metrics() {
    std::map<std::string, const MetricEntry*, std::less<>> metrics;
    for (const Section& section : sections())
        if (section.spacetime) metrics.emplace(section.name, find_metric(SpacetimeSpec{}.metric));
    return metrics;
}

int line_of(const toml::key& key) { return static_cast<int>(key.source().begin.line); }

// What may stand in a section; at the top level also the sections. metric: of a section that names one.
std::vector<std::string> words_of(std::string_view section, const MetricEntry* metric) {
    std::vector<std::string> words;
    for (const SceneKey& key : section.empty() ? scene_keys() : keys_of(section)) {
        const std::string_view word = section.empty() && !key.section.empty() ? key.section : key.key;
        if (std::find(words.begin(), words.end(), word) == words.end()) words.emplace_back(word);
    }
    if (metric != nullptr) {
        for (const MetricParameter& parameter : metric->parameters) words.emplace_back(parameter.name);
        for (const MetricFormula& formula : metric->formulas) words.emplace_back(formula.name);
    }
    return words;
}

// The row of a metric's parameter or formula, which are keys of a section that names a metric.
std::optional<SceneKey> parameter_key(std::string_view section, std::string_view name, const MetricEntry& metric) {
    for (const MetricParameter& parameter : metric.parameters)
        if (parameter.name == name)
            return SceneKey{.section = section,
                            .key = parameter.name,
                            .type = KeyType::kNumber,
                            .range = {parameter.low, parameter.high}};
    for (const MetricFormula& formula : metric.formulas)
        if (formula.name == name)
            return SceneKey{.section = section, .key = formula.name, .type = KeyType::kFormula, .choices = "r"};
    return std::nullopt;
}

class SceneReader {
public:
    SceneReader(std::string label, SceneFolders folders) : label_(std::move(label)), folders_(std::move(folders)) {}
    Result<Scene> read(const toml::table& root);

private:
    bool read_format(const toml::table& root);
    bool read_list(const Section& section, const toml::node& node);
    void read_section(const Section& section, const toml::table& table, const std::string& label);
    bool read_inner(const Section& section, std::string_view name, const toml::node& node);
    // label: the section's, as messages call it: "ball[2]".
    void read_key(std::string_view section, const toml::key& name, const toml::node& node, std::string_view label);
    void read_path_keys(const toml::node& node);
    void check_path_frames();
    void read_path_file();
    void report_unknown(std::string_view section, const toml::key& name);
    void report(int line, std::string_view name, std::string_view what, std::string_view allowed);
    void report(const SceneFault& fault);

    std::string label_;
    SceneFolders folders_;
    Scene scene_;
    fs::path path_file_;  // of path.file
    std::map<std::string, const MetricEntry*, std::less<>> metrics_ = default_metrics();
    std::vector<int> path_lines_;  // of [[path.key]]
    const MetricEntry* metric_of(std::string_view section) const {
        const auto found = metrics_.find(section);
        return found != metrics_.end() ? found->second : nullptr;
    }
    SpacetimeSpec& spec_of(std::string_view section) { return find_section(section)->spacetime.of(scene_); }
    std::map<std::string, int> lines_;  // of the keys that are there, by full name
    const GivenKeys given_ = [this](const std::string& name) { return lines_.contains(name); };
    std::map<std::string, int> sections_;  // lines where sections begin
    std::map<int, Error> reports_;         // what is wrong, by line; the first is returned
};

void SceneReader::report(int line, std::string_view name, std::string_view what, std::string_view allowed) {
    reports_.emplace(
        line, Error{ErrorKind::kBadInput, std::string(what), std::string(allowed), std::string(name), label_, line});
}

// At its key, else at the one that calls for it, else where its section begins.
void SceneReader::report(const SceneFault& fault) {
    const auto section = sections_.find(fault.key.substr(0, fault.key.find('.')));
    const int line = given_(fault.key)            ? lines_[fault.key]
                     : given_(fault.at)           ? lines_[fault.at]
                     : section != sections_.end() ? section->second
                                                  : 1;
    report(line, fault.key, fault.what, fault.allowed);
}

void SceneReader::report_unknown(std::string_view section, const toml::key& name) {
    const MetricEntry* metric = metric_of(section);
    const std::vector<std::string> words = words_of(section, metric);
    const std::string prefix = section.empty() ? "" : fmt::format("{}.", section);
    std::string nearest = nearest_word(name.str(), words);
    if (!nearest.empty()) nearest = prefix + nearest;
    for (const SceneKey& key : scene_keys()) {
        if (key.key != name.str()) continue;
        nearest = full_name(key);  // the right word in the wrong place
        break;
    }
    const std::string shown = in_quotes(name.str());
    const std::string what =
        metric != nullptr ? fmt::format("no parameter of metric \"{}\"", metric->key) : std::string("unknown key");
    report(line_of(name), prefix + shown.substr(1, shown.size() - 2), what,
           fmt::format("{}{}", fmt::join(words, ", "),
                       nearest.empty() ? "" : fmt::format(" (nearest known key: {})", nearest)));
}

void SceneReader::read_key(std::string_view section, const toml::key& name, const toml::node& node,
                           std::string_view label) {
    const std::string_view word = name_now(section, name.str());
    const SceneKey* row = find_key(section, word);
    const bool of_metric = row == nullptr && metrics_.contains(section);
    const MetricEntry* metric = metric_of(section);
    if (of_metric && metric == nullptr) return;  // the unknown metric is what will be reported
    const std::optional<SceneKey> key = row != nullptr ? *row
                                        : of_metric    ? parameter_key(section, name.str(), *metric)
                                                       : std::nullopt;
    if (!key) return report_unknown(section, name);
    const std::string full = section.empty() ? full_name(*key) : fmt::format("{}.{}", label, key->key);
    if (word != name.str() && given_(full))
        return report(line_of(name), full, "given twice, here by its old name", "once");
    lines_[full] = line_of(name);
    const Result<KeyValue> value = check_value(*key, node, folders_);
    if (!value)
        report(line_of(name), full, value.error().what, allowed_text(*key));
    else if (full == "path.file")
        path_file_ = value->path;
    else if (!of_metric)
        key->member.set(scene_, *value);
    else if (key->type == KeyType::kFormula)
        spec_of(section).parameters.formulas[std::string(key->key)] = value->text;
    else
        spec_of(section).parameters[std::string(key->key)] = value->number;
}

// What a scene may have several of, [[ball]], and one, [ball]. False: it is no list of sections.
bool SceneReader::read_list(const Section& section, const toml::node& node) {
    const toml::array* list = node.as_array();
    if (section.list == nullptr || list == nullptr || !list->is_array_of_tables()) return false;
    for (std::size_t i = 0; i < list->size(); ++i)
        read_section(section, *list->get_as<toml::table>(i), section_label(section.name, i));
    return true;
}

void SceneReader::read_section(const Section& section, const toml::table& table, const std::string& label) {
    const int line = std::max(static_cast<int>(table.source().begin.line), 1);
    if (section.optional()) section.add(scene_);
    if (const SectionList* list = section.list; list != nullptr && list->size(scene_) > list->most)
        return report(line, section.name, "one too many", fmt::format("at most {} {}", list->most, list->words));
    sections_[label] = line;
    const auto first = table.find(section.first);
    if (first != table.end()) read_key(section.name, first->first, first->second, label);
    if (const auto metric = metrics_.find(section.name); metric != metrics_.end() && first != table.end())
        metric->second = reports_.empty() ? find_metric(spec_of(section.name).metric) : nullptr;
    for (const auto& [name, node] : table)
        if (name.str() != section.first && !read_inner(section, name.str(), node))
            read_key(section.name, name, node, label);
}

// What stands in a section's table and is no key of it: a section in one line, camera = { r = 9, zoom = { depth = 3 } }, and [[path.key]],
// which read_path_keys() reads.
bool SceneReader::read_inner(const Section& section, std::string_view name, const toml::node& node) {
    if (!section.inner.empty() && name == section.inner) return true;
    const toml::table* table = node.as_table();
    const Section* within = table != nullptr ? find_section(name) : nullptr;
    if (within == nullptr || within->within.empty() || within->within != section.name) return false;
    read_section(*within, *table, std::string(name));
    return true;
}

// [[path.key]]: the camera's own keys, those of [zoom], and the frame where they hold. What a key leaves out is as in the one before it, and as in [camera]
// in the first.
void SceneReader::read_path_keys(const toml::node& node) {
    constexpr std::size_t kMostKeys = 10000;
    const toml::array* list = node.as_array();
    const int at = static_cast<int>(node.source().begin.line);
    if (list == nullptr || !list->is_array_of_tables() || list->size() > kMostKeys) {
        report(at, "path.key", "must be a list of sections", "[[path.key]], 10000 at most");
        return;
    }
    const CameraSpec camera = scene_.camera;
    const auto lines = lines_;
    for (const toml::node& entry : *list) {
        const toml::table& table = *entry.as_table();
        PathKey key;
        if (!scene_.path->keys.empty())
            key = {scene_.path->keys.back().frame + 1.0,
                   {},
                   scene_.path->keys.back().time,
                   scene_.path->keys.back().values};
        for (const auto& [name, value] : table) {
            if (const toml::table* set = value.as_table(); set != nullptr && name.str() == "set") {
                for (const NamedValue& one : named_values(*set))
                    if (const Status added = add_path_value(scene_, key, one, folders_); !added)
                        report(one.line, "path.key.set." + one.name, added.error().what, added.error().allowed);
                continue;
            }
            const bool time = name.str() == "time";
            if (!time && name.str() != "frame") {
                const bool zooms = find_key("zoom", name.str()) != nullptr;
                if (zooms && !scene_.camera.zoom) scene_.camera.zoom.emplace();
                const char* section = zooms ? "zoom" : "camera";
                read_key(section, name, value, section);
                continue;
            }
            const auto number = value.value<double>();
            const double low = time ? -1e9 : 0.0, high = time ? 1e9 : 1e6;
            if (!number || !(*number >= low && *number <= high))
                report(line_of(name), time ? "path.key.time" : "path.key.frame", "must be a number",
                       fmt::format("[{:.0f}, {:.0f}]", low, high));
            else
                (time ? key.time : key.frame) = *number;
        }
        key.camera = scene_.camera;
        const int here = static_cast<int>(entry.source().begin.line);
        if (!scene_.path->keys.empty() && !(key.frame > scene_.path->keys.back().frame))
            report(here, "path.key.frame", fmt::format("{} is not after the key before", key.frame),
                   "frames that grow");
        scene_.path->keys.push_back(key), path_lines_.push_back(here);
        for (const SceneFault& fault : check_camera(scene_, given_))
            if (reports_.empty()) report(here, fault.key, fault.what, fault.allowed);
    }
    scene_.camera = camera;
    lines_ = lines;
}

// At the last key before the frame that is wrong.
void SceneReader::check_path_frames() {
    if (!scene_.path || path_lines_.size() != scene_.path->keys.size()) return;
    const auto fault = path_fault(scene_);
    if (!fault) return;
    const auto& keys = scene_.path->keys;
    const auto after = std::ranges::upper_bound(keys, eased(*scene_.path, fault->frame), {}, &PathKey::frame);
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - keys.begin(), 1)) - 1;
    report(path_lines_[at], fault->key, fmt::format("in frame {} of the path: {}", fault->frame, fault->what),
           fault->allowed);
}

// An error is of that file.
void SceneReader::read_path_file() {
    const int line = lines_["path.file"];
    if (!scene_.path->keys.empty()) return report(line, "path.file", "there are [[path.key]] too", "one of both");
    const auto text = read_text(path_file_);
    if (!text) return report(line, "path.file", text.error().what, "a table of keys");
    auto table = read_path_csv(*text, path_file_.string(), scene_);
    if (!table) {
        reports_.emplace(line, table.error());
        return;
    }
    scene_.path->keys = std::move(table->keys);
    if (!table->by_axes) return;
    if (lines_.contains("path.turn") && scene_.path->turn != PathTurn::kShortest)
        report(lines_["path.turn"], "path.turn", "the file has the camera's axes, not its angles", "shortest");
    scene_.path->turn = PathTurn::kShortest;
}

// A file of a newer format is told so before anything else is said about it.
bool SceneReader::read_format(const toml::table& root) {
    const auto format = root.find("format");
    if (format == root.end()) return true;
    const auto number = format->second.value_exact<std::int64_t>();
    if (!number || *number <= kSceneFormat) return true;  // read_key
    report(line_of(format->first), "format",
           fmt::format("the file is of scene format {}, newer than this program; install a newer nullscope", *number),
           fmt::format("{}", kSceneFormat));
    return false;
}

Result<Scene> SceneReader::read(const toml::table& root) {
    if (!read_format(root)) return reports_.begin()->second;
    const std::vector<std::string> words = words_of("", nullptr);
    for (const auto& [name, node] : root) {
        const std::string word(name_now("", name.str()));
        const Section* section = word.empty() ? nullptr : find_section(word);
        if (const toml::table* table = node.as_table(); section != nullptr && table != nullptr) {
            if (sections_.contains(word))
                report(line_of(name), word, "given twice, once by its old name", "once");
            else
                read_section(*section, *table, word);
        } else if (section != nullptr && read_list(*section, node)) {
            continue;
        } else if (section != nullptr) {
            report(line_of(name), word, "must be a section", fmt::format("[{}]", word));
        } else {
            read_key("", name, node, "");
        }
    }
    if (reports_.empty()) {  // what follows compares values with each other
        settle_size(scene_, given_);
        for (const SceneFault& fault : check_camera(scene_, given_)) report(fault);
        if (const toml::node* keys = root.at_path("path.key").node(); keys != nullptr && scene_.path)
            read_path_keys(*keys);
        if (!path_file_.empty() && scene_.path->kind == PathKind::kKeys) read_path_file();
        settle_defaults(scene_, given_);
        if (scene_.name.empty()) scene_.name = fs::path(label_).stem().string();
        if (reports_.empty() || path_file_.empty())  // else there are no keys, which is not what is wrong
            for (const SceneFault& fault : check_parts(scene_, given_)) report(fault);
        if (reports_.empty()) check_path_frames();
    }
    if (reports_.empty()) return scene_;
    return without_controls(reports_.begin()->second);
}

}  // namespace

Result<Scene> parse_scene_in(const SceneFolders& folders, std::string_view toml_text, const std::string& file_label,
                             const SceneOverrides& overrides) {
    const auto replaced = [&](const SceneOverrides& some) -> Result<toml::table> {
        TRY(root, toml_of(toml_text, file_label));
        TRY(all, override_values(*root, some));
        return root;
    };
    TRY(root, replaced(overrides));
    auto scene = SceneReader(file_label, folders).read(*root);
    if (scene) return scene;
    return where_overridden(scene.error(), overrides, [&](const SceneOverrides& some) {
        const auto other = replaced(some);
        return other && SceneReader(file_label, folders).read(*other);
    });
}

Result<Scene> parse_scene(std::string_view toml_text, const std::string& file_label, const fs::path& base_directory) {
    return parse_scene_in({base_directory}, toml_text, file_label);
}

bool is_scene_line(std::string_view text) { return text.starts_with("scene = {"); }

Result<Scene> scene_of_line(std::string_view line) {
    TRY(root, toml_of(line.substr(0, line.find('\n')), "scene"));
    const toml::table* scene = root->get_as<toml::table>("scene");
    if (scene == nullptr || root->size() != 1) return bad_input("no scene", "scene = { camera = { r = 15 }, ... }");
    return SceneReader("scene", {{}}).read(*scene);
}

}  // namespace nullscope
