// Folders of this checkout and its build that tests read from or write to.
#pragma once
#include <filesystem>

namespace nullscope::test {

std::filesystem::path source_folder();   // the root of the checkout
std::filesystem::path data_folder();     // tests/
std::filesystem::path reports_folder();  // in the build folder; exists

}  // namespace nullscope::test
