#include "scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "scene/ball_motion.h"
#include "scene/body_check.h"
#include "scene/moving.h"
#include "scene/observer.h"
#include "scene/scene_value.h"
#include "scene/sides.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

// Dotted keys nest one table a dot, and toml++ frees tables recursively: 50 000 levels overflow the stack. It limits
// arrays and inline tables to 256 levels by itself.
constexpr std::ptrdiff_t kMostDots = 4096;

int line_of(const toml::key& key) { return static_cast<int>(key.source().begin.line); }

std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

// What may stand in a section; at the top level also the sections. metric: of a section that names one.
std::vector<std::string> words_of(std::string_view section, const MetricEntry* metric) {
    std::vector<std::string> words;
    for (const SceneKey& key : scene_keys()) {
        const std::string_view word = key.section == section ? key.key : section.empty() ? key.section : "";
        if (!word.empty() && std::find(words.begin(), words.end(), word) == words.end()) words.emplace_back(word);
    }
    if (metric != nullptr) {
        for (const MetricParameter& parameter : metric->parameters) words.emplace_back(parameter.name);
    }
    return words;
}

class SceneReader {
public:
    SceneReader(std::string label, fs::path base) : label_(std::move(label)), base_(std::move(base)) {}
    Result<Scene> read(const toml::table& root);

private:
    void read_section(std::string_view section, const toml::table& table);
    void read_key(std::string_view section, const toml::key& name, const toml::node& node);
    bool read_parameter(std::string_view section, const toml::key& name, const toml::node& node);
    void report_unknown(std::string_view section, const toml::key& name);
    void check_camera(int key_line = 0);  // key_line: of [[path.key]], 0 for [camera]
    void check_path();
    void read_path_keys(const toml::node& node);
    void check_place(std::string_view section, const SpacetimeSpec& spec, int key_line);
    void check_sky();
    void check_disc();
    void check_solids();
    void report_message(const std::string& message, const std::string& other);
    void check_motion(const SpacetimeSpec& spec, bool delay);
    void check_moving_keys();
    void check_throat(const SpacetimeSpec& spec);
    bool given(const std::string& name) const { return lines_.count(name) != 0; }
    int line(const std::string& name) const { return given(name) ? lines_.at(name) : 1; }
    void report(int line, std::string_view name, std::string_view what, std::string_view allowed);

    std::string label_;
    fs::path base_;
    Scene scene_;
    // The sections that name a metric, and which: null while the file names none that is known.
    std::map<std::string, const MetricEntry*, std::less<>> metrics_ = {
        {"spacetime", find_metric(SpacetimeSpec{}.metric)}, {"beside", find_metric(SpacetimeSpec{}.metric)}};
    const MetricEntry* metric_of(std::string_view section) const {
        const auto found = metrics_.find(section);
        return found != metrics_.end() ? found->second : nullptr;
    }
    SpacetimeSpec& spec_of(std::string_view section) { return section == "beside" ? *scene_.beside : scene_.spacetime; }
    std::map<std::string, int> lines_;     // of the keys that are there, by full name
    std::map<std::string, int> sections_;  // lines where sections begin
    std::map<int, std::string> reports_;   // what is wrong, by line; the first is returned
};

void SceneReader::report(int line, std::string_view name, std::string_view what, std::string_view allowed) {
    reports_.emplace(line, fmt::format("{}:{}: {}: {}; allowed: {}", label_, line, name, what, allowed));
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
           listed(words) + (nearest.empty() ? "" : fmt::format(" (nearest known key: {})", nearest)));
}

// False if the metric has no such parameter.
bool SceneReader::read_parameter(std::string_view section, const toml::key& name, const toml::node& node) {
    const MetricEntry* metric = metric_of(section);
    if (metric == nullptr) return true;  // the unknown metric is what will be reported
    for (const MetricParameter& parameter : metric->parameters) {
        if (parameter.name != name.str()) continue;
        const KeyRange range{parameter.low, parameter.high};
        const SceneKey key{section, parameter.name, KeyType::kNumber, "", "", range, "", "", nullptr};
        lines_[full_name(key)] = line_of(name);
        const auto checked = check_value(key, node, base_);
        if (const Fault* fault = std::get_if<Fault>(&checked)) {
            report(line_of(name), full_name(key), fault->what, allowed_text(key));
        } else {
            spec_of(section).parameters[std::string(parameter.name)] = std::get<KeyValue>(checked).number;
        }
        return true;
    }
    return false;
}

void SceneReader::read_key(std::string_view section, const toml::key& name, const toml::node& node) {
    for (const SceneKey& key : scene_keys()) {
        if (key.section != section || key.key != name.str()) continue;
        lines_[full_name(key)] = line_of(name);
        const auto checked = check_value(key, node, base_);
        if (const Fault* fault = std::get_if<Fault>(&checked)) {
            report(line_of(name), full_name(key), fault->what, allowed_text(key));
        } else {
            key.apply(scene_, std::get<KeyValue>(checked));
        }
        return;
    }
    if (!metrics_.contains(section) || !read_parameter(section, name, node)) report_unknown(section, name);
}

void SceneReader::read_section(std::string_view section, const toml::table& table) {
    if (section == "beside") scene_.beside.emplace();
    if (section == "disc") scene_.disc.emplace();
    if (section == "spot") scene_.spot.emplace();
    if (section == "sphere") scene_.sphere.emplace();
    if (section == "cylinder") scene_.cylinder.emplace();
    if (section == "ball") scene_.ball.emplace();
    if (section == "surface") scene_.surface.emplace();
    if (section == "path") scene_.path.emplace();
    sections_[std::string(section)] = table.source().begin.line == 0 ? 1 : static_cast<int>(table.source().begin.line);
    const auto of_metric = metrics_.find(section);
    if (const auto metric = table.find("metric"); of_metric != metrics_.end() && metric != table.end()) {
        read_key(section, metric->first, metric->second);  // first: it decides which other keys there are
        of_metric->second = reports_.empty() ? find_metric(spec_of(section).metric) : nullptr;
    }
    for (const auto& [name, node] : table) {
        if (section == "path" && name.str() == "key") continue;  // read_path_keys
        if (of_metric == metrics_.end() || name.str() != "metric") read_key(section, name, node);
    }
}

void SceneReader::check_camera(int key_line) {
    for (const char* other : {"camera.plane_width", "camera.focal_distance"}) {
        if (given("camera.fov") && given(other)) {
            report(std::max(line("camera.fov"), line(other)), "camera.fov", fmt::format("says the same as {}", other),
                   "either fov, or plane_width and focal_distance");
        }
    }
    constexpr std::pair<const char*, ObserverKind> kOfOne[] = {{"camera.fall_from", ObserverKind::kFall},
                                                               {"camera.energy", ObserverKind::kThrow}};
    for (const auto& [key, observer] : kOfOne)
        if (given(key) && scene_.camera.observer != observer)
            report(line(key), key, "camera.observer is another",
                   fmt::format("with observer = \"{}\" only", observer == ObserverKind::kFall ? "fall" : "throw"));
    check_place("spacetime", scene_.spacetime, key_line);
    const auto world = make_spacetime(scene_.spacetime.metric, scene_.spacetime.parameters);
    if (const Status parts = world ? check_light_parts(**world, scene_) : Done{}; !parts) {
        const int at = key_line > 0 ? key_line : line("camera.observer");
        reports_.emplace(at, fmt::format("{}:{}: {}", label_, at, parts.error().message));
    }
    if (scene_.beside) check_place("beside", *scene_.beside, key_line);
}

void SceneReader::check_place(std::string_view section, const SpacetimeSpec& spec, int key_line) {
    const auto spacetime = make_spacetime(spec.metric, spec.parameters);
    if (!spacetime) {  // its parameters, each within its range, do not go together
        const int at = line(std::string(section) + ".metric");
        reports_.emplace(at, fmt::format("{}:{}: {}.{}", label_, at, section, spacetime.error().message));
        return;
    }
    if (scene_.camera.observer == ObserverKind::kStatic && !camera_can_rest(**spacetime, scene_.camera.r)) {
        report(key_line > 0 ? key_line
                            : line(given("camera.r") ? std::string("camera.r") : std::string(section) + ".metric"),
               "camera.r",
               fmt::format("a static camera cannot be at {}{}", scene_.camera.r,
                           (*spacetime)->horizon_radius() ? ", on or inside the horizon" : ""),
               allowed_radii(**spacetime));
    } else if (const auto observer = observer_of(**spacetime, scene_.camera); !observer) {
        const int at = key_line > 0 ? key_line : std::max(line("camera.r"), line("camera.observer"));
        reports_.emplace(at, fmt::format("{}:{}: camera.observer: {}", label_, at, observer.error().message));
    }
}

// [[path.key]]: the camera's own keys, and the frame where they hold. What a key leaves out is as in the one before it, and as in [camera]
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
        PathKey key{scene_.path->keys.empty() ? 0.0 : scene_.path->keys.back().frame + 1.0, {}};
        for (const auto& [name, value] : table) {
            if (name.str() != "frame") {
                read_key("camera", name, value);
                continue;
            }
            const auto frame = value.value<double>();
            if (!frame || !(*frame >= 0.0 && *frame <= 1e6))
                report(line_of(name), "path.key.frame", "must be a number", "[0, 1000000]");
            else
                key.frame = *frame;
        }
        key.camera = scene_.camera;
        const int here = static_cast<int>(entry.source().begin.line);
        if (!scene_.path->keys.empty() && !(key.frame > scene_.path->keys.back().frame))
            report(here, "path.key.frame", fmt::format("{} is not after the key before", key.frame),
                   "frames that grow");
        scene_.path->keys.push_back(key);
        if (reports_.empty()) check_camera(here);
    }
    scene_.camera = camera;
    lines_ = lines;
}

void SceneReader::check_path() {
    if (!scene_.path) return;
    const bool keys = scene_.path->kind == PathKind::kKeys;
    if (keys ? scene_.path->keys.size() < 2 : !scene_.path->keys.empty())
        report(sections_["path"], "path.key",
               keys ? "fewer than two keys, but kind is keys" : "keys, but kind is not keys",
               keys ? "two [[path.key]] or more" : "with kind = \"keys\" only");
    if (keys && !given("path.frames") && !scene_.path->keys.empty())
        scene_.path->frames = std::max(2, static_cast<int>(scene_.path->keys.back().frame) + 1);
    for (const char* key : {"path.duration", "path.look"})
        if (keys && given(key)) report(line(key), key, "kind is not fall", "with kind = \"fall\" only");
    for (const PathKey& key : scene_.path->keys)
        if (key.camera.observer != scene_.path->keys.front().camera.observer ||
            key.camera.width != scene_.camera.width || key.camera.height != scene_.camera.height)
            report(sections_["path"], "path.key", "observer and size change on the way",
                   "one observer and one size for all keys");
}

void SceneReader::check_sky() {
    const bool far_image = scene_.far_sky.kind == SkyKind::kImage;
    if (far_image != given("far_sky.image"))
        report(line(far_image ? "far_sky.kind" : "far_sky.image"), "far_sky.image",
               far_image ? "missing, but kind is image" : "kind is not image",
               far_image ? "an image file" : "with kind = \"image\" only");
    for (const char* key : {"sky.faintest", "sky.even_stars"})
        if (scene_.sky.kind != SkyKind::kPoints && given(key))
            report(line(key), key, "kind is not points", "with kind = \"points\" only");
    if (given("sky.temperature") && (has_look(scene_.sky.kind) || scene_.sky.kind == SkyKind::kBlack))
        report(line("sky.temperature"), "sky.temperature", "kind is neither stars, image nor points",
               "with those kinds only");
    const bool image = scene_.sky.kind == SkyKind::kImage;
    const bool caps = scene_.sky.mapping == SkyMapping::kBandAndCaps;
    if (image && !given("sky.image")) {
        report(line("sky.kind"), "sky.image", "missing, but kind is image", "an image file");
    }
    if (!image && given("sky.image")) {
        report(line("sky.image"), "sky.image", "kind is not image", "with kind = \"image\" only");
    }
    if (!image && given("sky.mapping")) {
        report(line("sky.mapping"), "sky.mapping", "kind is not image", "with kind = \"image\" only");
    }
    for (const char* cap : {"sky.north_cap", "sky.south_cap"}) {
        if (!caps || given(cap)) continue;
        report(line("sky.mapping"), cap, "missing, but mapping is band-and-caps", "an image file");
    }
    for (const char* key : {"sky.north_cap", "sky.south_cap", "sky.band_latitude"}) {
        if (!caps && given(key)) {
            report(line(key), key, "mapping is not band-and-caps", "with mapping = \"band-and-caps\" only");
        }
    }
}

void SceneReader::check_disc() {
    for (const auto& [key, other] :
         {std::pair{"disc.mass", "disc.accretion_rate"}, {"disc.accretion_rate", "disc.mass"}}) {
        if (!given(key)) continue;
        if (!given(other)) report(line(key), other, fmt::format("missing, but there is a {}", key), "both or none");
        if (scene_.disc->emission != DiscEmission::kThermal)
            report(line(key), key, "emission is not thermal", "with emission = \"thermal\" only");
        if (given("disc.temperature"))
            report(line("disc.temperature"), "disc.temperature", fmt::format("{} gives the temperature", key),
                   "one of both");
    }
    if (!scene_.disc || scene_.disc->inner < scene_.disc->outer) return;
    const bool inner = given("disc.inner");
    report(line(inner ? "disc.inner" : "disc.outer"), inner ? "disc.inner" : "disc.outer",
           fmt::format("inner = {} is not below outer = {}", scene_.disc->inner, scene_.disc->outer), "inner < outer");
}

void SceneReader::check_solids() {
    const auto white_images = [this](const char* section, BodyLook& look) {
        if (look.texture == TextureKind::kImage && !given(fmt::format("{}.colour", section))) look.colour = {1, 1, 1};
    };
    if (scene_.sphere) white_images("sphere", scene_.sphere->look);
    if (scene_.cylinder) white_images("cylinder", scene_.cylinder->look);
    if (scene_.ball) white_images("ball", scene_.ball->look);
    if (scene_.surface) white_images("surface", scene_.surface->look);
    const auto spacetime = make_spacetime(scene_.spacetime.metric, scene_.spacetime.parameters);
    const double horizon = spacetime ? (*spacetime)->horizon_radius().value_or(0.0) : 0.0;
    const auto is_given = [this](const std::string& name) { return given(name); };
    for (const BodyFault& fault : check_bodies(scene_, horizon, is_given)) {
        const auto section = sections_.find(fault.key.substr(0, fault.key.find('.')));
        report(given(fault.key) ? line(fault.key) : section->second, fault.key, fault.what, fault.allowed);
    }
}

// "key: what; allowed: values", as errors beyond scene files are. Where the file does not give the key: at the line of another.
void SceneReader::report_message(const std::string& message, const std::string& other) {
    const std::string_view mark = "; allowed: ";
    const std::size_t colon = message.find(": "), allowed = message.find(mark);
    if (allowed == std::string::npos || colon > allowed)
        return report(line(other), other, message, "a value that can be used");
    const std::string key = message.substr(0, colon);
    report(line(given(key) ? key : other), key, message.substr(colon + 2, allowed - colon - 2),
           message.substr(allowed + mark.size()));
}

// What moves: whether it can, and whether its light's delay is known there.
void SceneReader::check_motion(const SpacetimeSpec& spec, bool delay) {
    const auto spacetime = make_spacetime(spec.metric, spec.parameters);
    const auto moving = moving_parts(scene_);
    if (!spacetime || moving.empty()) return;
    const Spacetime& world = **spacetime;
    if (delay && !world.knows_light_time())
        report(1, moving.front(), fmt::format("how long light takes is not known in metric \"{}\"", spec.metric),
               "light.delay = \"off\", or another metric");
    if (scene_.spot && scene_.disc && !circular_orbit(world, scene_.spot->r))
        report(given("spot.r") ? line("spot.r") : sections_["spot"], "spot.r",
               fmt::format("no circular orbit at {}", scene_.spot->r), "r outside the photon sphere");
    if (!scene_.ball || scene_.ball->motion == BallMotion::kStill) return;
    if (world.by_proper_length())
        report(line("ball.motion"), "ball.motion", "nothing moves in a wormhole", "still");
    else if (const auto motion = ball_motion(world, *scene_.ball); !motion)
        report_message(motion.error().message, "ball.motion");
}

void SceneReader::check_moving_keys() {
    const auto only = [this](const char* key, bool meant, const char* with) {
        if (!meant && given(key)) report(line(key), key, "has no meaning here", fmt::format("with {} only", with));
    };
    only("disc.flow_life", scene_.disc && scene_.disc->flow == DiscFlowKind::kKepler, "flow = \"kepler\"");
    only("sphere.period", scene_.sphere && scene_.sphere->swing > 0.0, "swing above 0");
    const BallMotion motion = scene_.ball ? scene_.ball->motion : BallMotion::kStill;
    only("ball.velocity", motion == BallMotion::kGeodesic, "motion = \"geodesic\"");
    for (const char* key : {"ball.x", "ball.y", "ball.z"}) {
        only(key, motion == BallMotion::kPath, "motion = \"path\"");
        if (motion == BallMotion::kPath && !given(key))
            report(line("ball.motion"), key, "missing, but motion is path", "a formula of t");
    }
    if (!scene_.spot) return;
    if (!scene_.disc)
        report(sections_["spot"], "spot", "there is no [disc]",
               "in a disc only; disc.opacity = 0 shows the spots alone");
    else if (!(scene_.spot->r > scene_.disc->inner && scene_.spot->r < scene_.disc->outer))
        report(given("spot.r") ? line("spot.r") : sections_["spot"], "spot.r",
               fmt::format("{} is not within the disc", scene_.spot->r),
               fmt::format("({}, {})", scene_.disc->inner, scene_.disc->outer));
}

// What stands on the sides of a wormhole, and what cannot.
void SceneReader::check_throat(const SpacetimeSpec& spec) {
    const auto spacetime = make_spacetime(spec.metric, spec.parameters);
    if (!spacetime) return;
    for (const SideFault& fault : side_faults(**spacetime, scene_)) {
        const std::string section = fault.key.substr(0, fault.key.find('.'));
        const auto at = sections_.find(section);
        report(given(fault.key)        ? line(fault.key)
               : at != sections_.end() ? at->second
                                       : line("spacetime.metric"),
               fault.key, fault.what, fault.allowed);
    }
}

Result<Scene> SceneReader::read(const toml::table& root) {
    const std::vector<std::string> words = words_of("", nullptr);
    for (const auto& [name, node] : root) {
        const auto is_section = [&, &word = name](const SceneKey& key) { return key.section == word.str(); };
        const bool section = std::any_of(scene_keys().begin(), scene_keys().end(), is_section) && !name.str().empty();
        if (const toml::table* table = node.as_table(); section && table != nullptr) {
            read_section(name.str(), *table);
        } else if (section) {
            report(line_of(name), name.str(), "must be a section", fmt::format("[{}]", name.str()));
        } else {
            read_key("", name, node);
        }
    }
    if (reports_.empty()) {  // what follows compares values with each other
        check_camera();
        if (const toml::node* keys = root.at_path("path.key").node(); keys != nullptr && scene_.path)
            read_path_keys(*keys);
        check_path();
        check_sky();
        check_disc();
        check_solids();
        check_throat(scene_.spacetime);
        if (scene_.beside) check_throat(*scene_.beside);
        check_moving_keys();
    }
    if (reports_.empty()) {
        check_motion(scene_.spacetime, scene_.light.delay);
        if (scene_.beside) check_motion(*scene_.beside, scene_.light.delay && scene_.beside_delay);
    }
    if (!reports_.empty()) return bad_input(without_controls(reports_.begin()->second));
    if (scene_.name.empty()) scene_.name = fs::path(label_).stem().string();
    return scene_;
}

}  // namespace

Result<Scene> parse_scene(std::string_view toml_text, const std::string& file_label, const fs::path& base_directory) {
    const auto refuse = [&](const std::string& what) { return bad_input(without_controls(file_label + what)); };
    if (toml_text.size() > kLargestSceneFile) return refuse(fmt::format(": larger than {} bytes", kLargestSceneFile));
    if (std::count(toml_text.begin(), toml_text.end(), '.') > kMostDots) {
        return refuse(fmt::format(":1: more than {} dots: keys could nest too deeply", kMostDots));
    }
    try {
        const toml::table root = toml::parse(toml_text);
        return SceneReader(file_label, base_directory).read(root);
    } catch (const toml::parse_error& error) {
        return refuse(fmt::format(":{}: {}", error.source().begin.line, error.description()));
    }
}

}  // namespace nullscope
