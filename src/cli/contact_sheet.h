// Many pictures, small, on one sheet, each above its label.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace nullscope::cli {

struct SheetTile {
    std::filesystem::path picture;  // display-ready
    std::string label;
};

// A PNG, at most 8192 px wide and 16384 high: tiles of 64 to 240 px. Without a font it has no labels. Errors: a picture that cannot be read, too
// many of them, the file cannot be written.
Status write_contact_sheet(const std::filesystem::path& file, const std::vector<SheetTile>& tiles, int columns);

}  // namespace nullscope::cli
