// Inside shaderlib only: what is done to the text of shaders/ before a driver sees it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nullscope {

// Drops comments and blank lines: the driver's text is what is compiled, nothing else.
std::string stripped(std::string_view text);

// Keeps or drops the branches of #ifdef / #ifndef / #else / #endif for the macros that are ours (EFFECT_, BLOCK_, NEEDS_, ...), so
// that nothing of an effect that is off is left in the text.
std::string resolved_branches(const std::string& text, const std::vector<std::string>& defines);

}  // namespace nullscope
