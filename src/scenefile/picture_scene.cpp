#include "scenefile/picture_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "base/file_part.h"
#include "base/numbered_files.h"
#include "base/sha256.h"
#include "base/text.h"
#include "image/picture_texts.h"
#include "plan/dump_window.h"
#include "scene/medium_dumps.h"
#include "scenefile/photo_sphere.h"
#include "scenefile/scene_writer.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

// What a grid of matter says before its numbers (scene/medium_grid.h), which its converter may have put there. Empty: another file.
std::string grid_head(const fs::path& file) {
    constexpr std::string_view kFirst = "nullscope-medium ", kLast = "\ndata\n";
    constexpr std::size_t kMostHead = 1u << 16;
    const std::string head = file_part(file, kMostHead, FileEnd::kFirst);
    const std::size_t end = head.find(kLast);
    return head.starts_with(kFirst) && end != std::string::npos ? head.substr(0, end) : "";
}

using NamedFiles = std::vector<std::pair<std::string, fs::path>>;  // as written, and where they are

// Files of a scene; of dumps those about the times.
NamedFiles files_at(const Scene& scene, const WrittenScene& written, const std::vector<double>& times) {
    NamedFiles files;
    for (const auto& [name, file] : written.files) {
        if (!has_dumps(scene) || file != scene.medium->grid.file) {
            files.emplace_back(name, file);
            continue;
        }
        std::set<fs::path> dumps;
        for (const double time : times)
            for (fs::path& dump : dumps_seen(scene, time)) dumps.insert(std::move(dump));
        for (const fs::path& dump : dumps)
            files.emplace_back((fs::path(name).parent_path() / dump.filename()).string(), dump);
    }
    return files;
}

// Adds them to the words: a line of each, as sha256sum prints it, and the heads of grids.
Status add_files(const NamedFiles& files, std::map<std::string, std::string>& words) {
    std::string& lines = words[kFilesWord];
    for (const auto& [written, file] : files) {
        TRY(hash, sha256_of(file));
        const std::string line = fmt::format("{}  {}", *hash, written);
        if (lines.find(line) == std::string::npos) lines += (lines.empty() ? "" : "\n") + line;
        if (const std::string head = grid_head(file); !head.empty()) words["nullscope.grid_head"] = head;
    }
    return Done{};
}

// Files that are no longer those that the picture was drawn from.
void say_other_files(const std::map<std::string, std::string>& words, const Scene& scene, const WrittenScene& written,
                     const std::string& picture, const Note& note) {
    NamedFiles known = written.files;
    if (has_dumps(scene)) {  // which of them, the picture says
        const GridMatter& dumps = scene.medium->grid;
        const auto files = NumberedFiles::parse(dumps.file.filename().string(), dumps.file.parent_path().string());
        const auto pattern = std::ranges::find(known, dumps.file, &std::pair<std::string, fs::path>::second);
        const fs::path folder = pattern != known.end() ? fs::path(pattern->first).parent_path() : fs::path();
        for (int number = dumps.first; files && number <= dumps.last; ++number) {
            const fs::path file = files->of(number);
            known.emplace_back((folder / file.filename()).string(), file);
        }
    }
    const auto files = words.find(kFilesWord);
    if (files == words.end()) return;
    for (const std::string& line : split(files->second, '\n')) {
        constexpr std::size_t kDigits = 64;
        if (line.size() < kDigits + 2) continue;
        const auto found = std::ranges::find(known, line.substr(kDigits + 2), &std::pair<std::string, fs::path>::first);
        if (found == known.end()) continue;
        const auto now = sha256_of(found->second);
        if (now && *now != line.substr(0, kDigits))
            note(without_controls(
                fmt::format("{}: {} is not the file that the picture was drawn from (SHA-256 {}, it was {})", picture,
                            in_quotes(found->second.string()), now->substr(0, 12), line.substr(0, 12))));
    }
}

}  // namespace

void note_on_terminal(const std::string& line) { fmt::print(stderr, "{}\n", line); }

Result<std::map<std::string, std::string>> picture_words(const PictureOrigin& origin) {
    const WrittenScene written = written_scene(origin.scene, origin.folders);
    std::map<std::string, std::string> words = {{"nullscope.scene", origin.scene.name},
                                                {kSceneWord, written.text},
                                                {"nullscope.scene_hash", fmt::format("{:016x}", fnv1a(written.text))},
                                                {"nullscope.version", origin.version}};
    const std::vector<double> times = origin.times.empty() ? std::vector{origin.scene.time} : origin.times;
    TRY(added, add_files(files_at(origin.scene, written, times), words));
    if (origin.split) {
        const WrittenScene other = written_scene(*origin.split, origin.split_folders);
        words[kSplitWord] = other.text;
        TRY(more, add_files(files_at(*origin.split, other, times), words));
    }
    if (origin.frame) words[kFrameWord] = fmt::format("{}", *origin.frame);
    words[kOptionsWord] = origin.options;
    words["nullscope.renderer"] = origin.renderer;
    std::erase_if(words, [](const auto& word) { return word.second.empty(); });
    return words;
}

Result<std::map<std::string, std::string>> displayed_picture_words(const PictureOrigin& origin) {
    TRY(words, picture_words(origin));
    const bool one = !origin.split && !origin.scene.split;
    if (std::string packet = photo_sphere_packet(origin.scene.camera); one && !packet.empty())
        (*words)[kXmpWord] = std::move(packet);
    return std::move(*words);
}

SceneFolders picture_folders(const fs::path& file) { return {file.parent_path(), {}, assets_directory() / "scenes"}; }

Result<Scene> scene_of_words(const std::map<std::string, std::string>& words, const std::string& keyword,
                             const std::string& file, const Note& note, const SceneOverrides& overrides) {
    const auto text = words.find(keyword);
    if (text == words.end())
        return bad_input(
            without_controls(fmt::format("{}: this picture holds no scene; pictures drawn by nullscope hold it as {}",
                                         in_quotes(file), kSceneWord)));
    const SceneFolders folders = picture_folders(file);
    TRY(scene, parse_scene_in(folders, text->second, file, overrides));
    say_other_files(words, *scene, written_scene(*scene, folders), file, note);
    return scene;
}

Result<OpenedScene> open_picture(const std::string& file, const Note& note, const SceneOverrides& overrides) {
    TRY(words, load_texts(file));
    TRY(scene, scene_of_words(*words, kSceneWord, file, note, overrides));
    return OpenedScene{std::move(*scene), picture_folders(file), std::move(*words)};
}

}  // namespace nullscope
