// Under which name a scene is saved.
#pragma once
#include <filesystem>
#include <string>

namespace nullscope::viewer {

// NAME.toml in the current folder, absolute; NAME-2, NAME-3 ... where that exists. Of the name its letters and digits.
std::filesystem::path fresh_scene_path(const std::string& name);

class SaveAs {
public:
    // Asks in the next frames, beginning with this path.
    void ask(const std::filesystem::path& proposed);
    // Between NewFrame and Render. The absolute path that was chosen, or "". A file that exists is refused: it is someone's. escape: the key was
    // pressed, and gives it up.
    std::string draw(bool escape);

private:
    bool open_ = false, asked_now_ = false;
    std::string path_, refusal_;
};

}  // namespace nullscope::viewer
