#include "scenefile/picture_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "base/sha256.h"
#include "base/text.h"
#include "image/picture_texts.h"
#include "scenefile/scene_writer.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

// What a grid of matter says before its numbers (scene/medium_grid.h), which its converter may have put there. Empty: another file.
std::string grid_head(const fs::path& file) {
    constexpr std::string_view kFirst = "nullscope-medium ", kLast = "\ndata\n";
    constexpr std::size_t kMostHead = 1u << 16;
    std::string head(kMostHead, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    const std::size_t end = head.find(kLast);
    return head.starts_with(kFirst) && end != std::string::npos ? head.substr(0, end) : "";
}

// Adds the files of a scene to the words: a line of each, as sha256sum prints it, and the heads of grids.
Status add_files(const WrittenScene& scene, std::map<std::string, std::string>& words) {
    std::string& lines = words[kFilesWord];
    for (const auto& [written, file] : scene.files) {
        TRY(hash, sha256_of(file));
        const std::string line = fmt::format("{}  {}", *hash, written);
        if (lines.find(line) == std::string::npos) lines += (lines.empty() ? "" : "\n") + line;
        if (const std::string head = grid_head(file); !head.empty()) words["nullscope.grid_head"] = head;
    }
    return Done{};
}

// Files that are no longer those that the picture was drawn from.
void say_other_files(const std::map<std::string, std::string>& words, const WrittenScene& scene,
                     const std::string& picture, const Note& note) {
    const auto files = words.find(kFilesWord);
    if (files == words.end()) return;
    for (const std::string& line : split(files->second, '\n')) {
        constexpr std::size_t kDigits = 64;
        if (line.size() < kDigits + 2) continue;
        const auto found =
            std::ranges::find(scene.files, line.substr(kDigits + 2), &std::pair<std::string, fs::path>::first);
        if (found == scene.files.end()) continue;
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
    TRY(added, add_files(written, words));
    if (origin.split) {
        const WrittenScene other = written_scene(*origin.split, origin.split_folders);
        words[kSplitWord] = other.text;
        TRY(more, add_files(other, words));
    }
    if (origin.frame) words[kFrameWord] = fmt::format("{}", *origin.frame);
    words[kOptionsWord] = origin.options;
    words["nullscope.renderer"] = origin.renderer;
    std::erase_if(words, [](const auto& word) { return word.second.empty(); });
    return words;
}

SceneFolders picture_folders(const fs::path& file) { return {file.parent_path(), {}, assets_directory() / "scenes"}; }

Result<Scene> scene_of_words(const std::map<std::string, std::string>& words, const std::string& keyword,
                             const std::string& file, const Note& note) {
    const auto text = words.find(keyword);
    if (text == words.end())
        return bad_input(
            without_controls(fmt::format("{}: this picture holds no scene; pictures drawn by nullscope hold it as {}",
                                         in_quotes(file), kSceneWord)));
    const SceneFolders folders = picture_folders(file);
    TRY(scene, parse_scene_in(folders, text->second, file));
    say_other_files(words, written_scene(*scene, folders), file, note);
    return scene;
}

Result<OpenedScene> open_picture(const std::string& file, const Note& note) {
    TRY(words, load_texts(file));
    TRY(scene, scene_of_words(*words, kSceneWord, file, note));
    return OpenedScene{std::move(*scene), picture_folders(file), std::move(*words)};
}

}  // namespace nullscope
