// nullscope devices: what OpenGL devices and drivers are here, what they can, which one is taken; and how exactly and fast each draws.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "cli/command.h"
#include "command/device_trial.h"
#include "command/exact_trace.h"
#include "command/json.h"
#include "compare/ray_metrics.h"
#include "compare/remembered_trace.h"
#include "image/image_file.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {
namespace {

struct DevicesOptions {
    std::vector<std::string> scenes = {"first-light", "kerr", "accretion", "soft-disc", "wormhole", "swarm", "zoom"};
    std::optional<int> device;
    std::string size = "320x180", pictures;
    bool measure = false, json = false;
    double limit_s = 60;
};

// A scene on a device, judged.
struct TrialRow {
    std::string scene, failure;
    double position_px = 0, first_ms = 0, frame_ms = 0, frame_core_ms = 0;
    long long wrong_fates = 0;
    int picture = 0;  // largest difference to the first device that drew it, of 255
};

struct DeviceRow {
    int number = 0;
    DeviceFacts facts;
    bool taken = false;          // by commands that are not told otherwise
    std::optional<int> same_as;  // a device before it, whose driver says the same of itself
    std::vector<TrialRow> trials;
};

std::string name_of(const ContextDevice& device) {
    std::string name = device.place.empty() ? device.kind : fmt::format("{}, {}", device.kind, device.place);
    return device.file.empty() ? name : fmt::format("{} ({})", name, device.file);
}

Result<std::vector<DeviceRow>> found_devices(const DevicesOptions& options) {
    TRY(facts, device_facts(options.limit_s));
    std::vector<DeviceRow> rows;
    bool taken = false;
    for (DeviceFacts& of_one : *facts) {
        DeviceRow row{static_cast<int>(rows.size()), std::move(of_one), false, {}, {}};
        const DeviceFacts& own = row.facts;
        if (own.failure.empty()) {
            row.taken = !std::exchange(taken, true);
            for (const DeviceRow& before : rows)
                if (before.facts.failure.empty() && before.facts.device.kind == own.device.kind &&
                    before.facts.info.renderer == own.info.renderer && before.facts.info.version == own.info.version &&
                    !row.same_as)
                    row.same_as = before.number;
        }
        rows.push_back(std::move(row));
    }
    if (!options.device) return rows;
    if (*options.device >= static_cast<int>(rows.size()))
        return bad_input(fmt::format("--device {}: there is none of this number", *options.device),
                         rows.empty() ? "none" : fmt::format("0 to {}", rows.size() - 1));
    return std::vector{std::move(rows[static_cast<std::size_t>(*options.device)])};
}

int largest_difference(const Image<unsigned char>& a, const Image<unsigned char>& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) largest = std::max(largest, std::abs(a.data[i] - b.data[i]));
    return largest;
}

TrialRow judged(const Scene& scene, const DeviceTrial& trial, const DeviceTrial& first, const ExactTrace& exact) {
    TrialRow row{scene.name, trial.failure};
    if (!trial.failure.empty()) return row;
    const RayMeasures m =
        measure_rays(trial.rays, scene.camera, exact, kTrialRowStep, kDisplaceAbove_px, kFloatDirection_rad);
    row.position_px = std::max(m.sky_px.max, m.place_px.max);
    row.wrong_fates = m.fate_errors, row.first_ms = trial.first_ms, row.frame_ms = trial.frame_ms;
    row.frame_core_ms = trial.frame_core_ms;
    row.picture = largest_difference(trial.picture, first.picture);
    return row;
}

// Every scene on every device, and then the judgement: where this process has threads, it can make no others (fork_child).
Status measure(const DevicesOptions& options, std::vector<DeviceRow>& rows) {
    std::vector<Scene> scenes;
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene_sized(name, options.size));
        scene->name = name;
        scenes.push_back(std::move(*scene));
    }
    const auto drawn = [](const DeviceRow& row) { return row.facts.failure.empty() && !row.same_as; };
    std::vector<std::vector<DeviceTrial>> trials(rows.size());
    {
        Progress progress("devices", std::ranges::count_if(rows, drawn) * static_cast<long long>(scenes.size()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const Scene& scene : scenes) {
                if (!drawn(rows[i])) continue;
                TRY(trial, device_trial(rows[i].number, scene, options.limit_s));
                trials[i].push_back(std::move(*trial));
                progress.advance();
            }
    }
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const Scene& scene = scenes[k];
        const ExactTrace exact = remembered(exact_trace(scene), scene.camera.width, scene.camera.height);
        const DeviceTrial* first = nullptr;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (trials[i].empty()) continue;
            const DeviceTrial& trial = trials[i][k];
            if (first == nullptr && trial.failure.empty()) first = &trial;
            rows[i].trials.push_back(judged(scene, trial, first == nullptr ? trial : *first, exact));
            if (options.pictures.empty() || !trial.failure.empty()) continue;
            const std::string file = std::filesystem::path(scene.name).stem().string();
            TRY(saved,
                save_png(std::filesystem::path(options.pictures) / fmt::format("{}-{}.png", file, rows[i].number),
                         trial.picture));
        }
    }
    return Done{};
}

std::string abilities_words(const DeviceFacts& facts) {
    const gl::Abilities& can = facts.can;
    std::string words = can.software ? "software" : "hardware";
    if (can.vector_bits > 0) words += fmt::format(", vectors of {} bits", can.vector_bits);
    words += can.computes ? "; compute shaders" : "; no compute shaders";
    words += fmt::format("; textures to {} px, {} layers, targets to {} px", facts.info.max_texture_size,
                         facts.info.max_layers, facts.info.max_renderbuffer_size);
    words += can.float_targets ? "; float targets" : "; no float targets";
    return words + (can.timer ? "; timer" : "; no timer");
}

void print_trials(const std::vector<TrialRow>& trials) {
    std::size_t widest = 5;
    for (const TrialRow& t : trials) widest = std::max(widest, t.scene.size());
    fmt::print("   {:<{}}  {:>12}  {:>12}  {:>11}  {:>9}  {:>9}\n", "scene", widest, "position, px", "wrong fates",
               "picture/255", "first, ms", "frame, ms");
    for (const TrialRow& t : trials)
        if (t.failure.empty())
            fmt::print("   {:<{}}  {:>12.2g}  {:>12}  {:>11}  {:>9.0f}  {:>9.2f}\n", t.scene, widest, t.position_px,
                       t.wrong_fates, t.picture, t.first_ms, t.frame_ms);
        else
            fmt::print("   {:<{}}  {}\n", t.scene, widest, t.failure);
}

void print_text(const std::vector<DeviceRow>& rows) {
    for (const DeviceRow& row : rows) {
        const DeviceFacts& f = row.facts;
        fmt::print("{}  {}\n", row.number, name_of(f.device));
        if (!f.failure.empty()) {
            fmt::print("   {}\n", f.failure);
            continue;
        }
        if (row.same_as) {
            fmt::print("   as {}: {}\n", *row.same_as, f.info.renderer);
            continue;
        }
        fmt::print("   {} ({}), OpenGL {}, GLSL {}\n   {}\n", f.info.renderer, f.info.vendor, f.info.version,
                   f.info.glsl, abilities_words(f));
        if (row.taken) fmt::print("   taken where neither --device nor --context is given\n");
        if (!row.trials.empty()) print_trials(row.trials);
    }
}

Json json_of(const DeviceRow& row) {
    const DeviceFacts& f = row.facts;
    Json json{{"number", row.number}, {"kind", f.device.kind}, {"place", f.device.place}, {"file", f.device.file}};
    if (!f.failure.empty()) return json["failure"] = f.failure, json;
    json.update(Json{{"taken", row.taken},
                     {"renderer", f.info.renderer},
                     {"vendor", f.info.vendor},
                     {"version", f.info.version},
                     {"glsl", f.info.glsl},
                     {"software", f.can.software},
                     {"vector_bits", f.can.vector_bits},
                     {"compute", f.can.computes},
                     {"largest_texture", f.info.max_texture_size},
                     {"largest_target", f.info.max_renderbuffer_size},
                     {"most_layers", f.info.max_layers},
                     {"float_targets", f.can.float_targets},
                     {"timer", f.can.timer}});
    if (row.same_as) json["same_as"] = *row.same_as;
    for (const TrialRow& t : row.trials) {
        Json trial{{"scene", t.scene}};
        if (t.failure.empty())
            trial.update(Json{{"position_px", t.position_px},
                              {"wrong_fates", t.wrong_fates},
                              {"picture_difference", t.picture},
                              {"first_ms", t.first_ms},
                              {"frame_ms", t.frame_ms},
                              {"frame_core_ms", t.frame_core_ms}});
        else
            trial["failure"] = t.failure;
        json["scenes"].push_back(std::move(trial));
    }
    return json;
}

Result<int> run_devices(const DevicesOptions& options) {
    if (!options.measure && !options.pictures.empty())
        return bad_input("--pictures: nothing is drawn", "with --measure");
    if (std::error_code none; !options.pictures.empty() && !std::filesystem::is_directory(options.pictures, none))
        return failed(fmt::format("--pictures {}: there is no such folder", options.pictures));
    TRY(rows, found_devices(options));
    if (options.measure) {
        TRY(measured, measure(options, *rows));
    }
    if (options.json) {
        Json all = Json::array();
        for (const DeviceRow& row : *rows) all.push_back(json_of(row));
        fmt::print("{}", json_text(all));
    } else {
        print_text(*rows);
    }
    return std::ranges::any_of(*rows, [](const DeviceRow& row) { return row.facts.failure.empty(); }) ? 0 : 1;
}

}  // namespace

void add_devices(Command& parent) {
    auto [command, options] = add_command<DevicesOptions>(
        parent, "devices",
        "List the OpenGL devices and drivers here, with what they can and which one is taken; each is asked in a "
        "process of its own, which it may end",
        run_devices);
    command.add_option("scenes", &options.scenes, "Scenes to draw with --measure").show_default();
    command.add_option("--device", &options.device, "This one alone, by its number in the list").in_range(0, 1000);
    command.add_flag("--measure", &options.measure,
                     "Draw the scenes on each: largest error of the rays' places against the reference, pixels whose "
                     "rays end elsewhere, largest difference of the picture to that of the first device, time");
    text_option(command, "--size", options.size, "Picture size, WIDTHxHEIGHT");
    number_option(command, "--limit", options.limit_s, 1, 1e6, "Seconds for a scene on a device, then it is given up");
    command.add_option("--pictures", &options.pictures,
                       "Folder for the pictures of --measure, SCENE-NUMBER.png; it must exist");
    command.add_flag("--json", &options.json, "Print one JSON array");
}

}  // namespace nullscope::cli
