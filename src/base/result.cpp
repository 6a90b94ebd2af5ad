#include "base/result.h"

#include <fmt/format.h>

namespace nullscope {

std::string Error::message() const {
    std::string text;
    if (!file.empty()) text += line > 0 ? fmt::format("{}:{}: ", file, line) : file + ": ";
    if (!key.empty()) text += key + ": ";
    text += what;
    if (!allowed.empty()) text += "; allowed: " + allowed;
    return text;
}

}  // namespace nullscope
