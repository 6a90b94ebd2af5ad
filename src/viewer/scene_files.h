// How scenes come from files and get into them.
#pragma once
#include <filesystem>
#include <optional>

#include "studio/autosave.h"
#include "viewer/file_dialog.h"
#include "viewer/save_as.h"

namespace nullscope::viewer {

struct SceneFiles {
    FileDialog dialog;
    SaveAs save_as;
    Autosave autosave;
    std::optional<std::filesystem::path> left;  // scene of a viewer that did not end as it should
};

}  // namespace nullscope::viewer
