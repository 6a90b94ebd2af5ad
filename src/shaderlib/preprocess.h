// What is done to the text of shaders/ before a compiler sees it. Knows no embedded file: src/coretexts reads a folder.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope {

// The text that #include "NAME" stands for: a file of shaders/ by its path there, or a part that the caller has written
// ("generated/..."). What it views must outlive the call that is given the reader.
using ShaderReader = std::function<std::string_view(std::string_view name)>;

// What #include "path/NAME" stands for: NAME of the kind of path that a frame's light takes, folder `kind` of shaders/.
inline constexpr std::string_view kPathPrefix = "path/";
std::string path_line(std::string_view kind, std::string_view name);

// Keeps or drops the branches of #ifdef / #ifndef / #else / #endif, so that nothing of an effect that is off is left in
// the text. A name is defined if it is among `defines`, or by a line #define before. Nothing else is changed.
std::string resolved_branches(std::string_view text, const std::vector<std::string>& defines);

// The text of `root` with its branches resolved and, in those that are kept, every #include replaced by the text it
// names, the first time that it is met. Comments are dropped. Where line numbers jump there is a #line: line N of file F
// is 10000 F + N (Mesa forgets the number of a source string); files are numbered from 1 in their order, and before a
// file's first #line a comment has its name (gl::explained_log reads it). With __cplusplus among `defines` #line has the
// line and the name itself.
std::string resolved_text(std::string_view root, const std::vector<std::string>& defines, const ShaderReader& read);

}  // namespace nullscope
