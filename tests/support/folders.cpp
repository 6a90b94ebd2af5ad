#include "support/folders.h"

namespace nullscope::test {

std::filesystem::path source_folder() { return NULLSCOPE_SOURCE_DIR; }

std::filesystem::path data_folder() { return source_folder() / "tests"; }

std::filesystem::path reports_folder() {
    std::filesystem::create_directories(NULLSCOPE_REPORTS);
    return NULLSCOPE_REPORTS;
}

}  // namespace nullscope::test
