// Under which name a scene is saved.
#pragma once
#include <filesystem>
#include <string>

namespace nullscope::viewer {

// NAME.toml in the current folder, absolute; NAME-2, NAME-3 ... where that exists. Of the name its letters and digits.
std::filesystem::path fresh_scene_path(const std::string& name);

// The first line of files that this program writes. One that has it, and no other comment, may be written over: nothing of others is lost.
inline constexpr const char* kSavedMark = "# Saved by nullscope-viewer\n";
bool may_be_replaced(const std::filesystem::path& file);

class SaveAs {
public:
    // Asks in the next frames, beginning with this path.
    void ask(const std::filesystem::path& proposed);
    // Between NewFrame and Render. The absolute path that was chosen, or "". A file that exists is replaced when it may be and when one
    // says so twice. escape: the key was pressed, and gives it up.
    std::string draw(bool escape);

private:
    bool open_ = false, asked_now_ = false;
    std::string path_, refusal_, replaced_;
};

}  // namespace nullscope::viewer
