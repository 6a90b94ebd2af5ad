// Which nullscope this is. The version has one place, project() of the top CMakeLists.txt; the commit is found whenever the program is built
// (src/version/version.cmake).
#pragma once

namespace nullscope {

extern const char* const kVersion;  // "1.0.0"
extern const char* const
    kVersionText;  // "1.0.0 (3f2a91c07b1d)", "1.0.0 (3f2a91c07b1d, changed)"; "1.0.0" where there is no repository

}  // namespace nullscope
