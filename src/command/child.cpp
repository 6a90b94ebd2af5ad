#include "command/child.h"

#include <fmt/format.h>

namespace nullscope::cli {

Result<ChildAnswer> answer_of_child(const std::function<int(int pipe)>& run, double limit_s) {
    ChildAnswer answer;
    if (const std::error_code error = platform::answer_of_child(run, limit_s, answer))
        return failed(fmt::format("a process of its own: {}", error.message()));
    return answer;
}

}  // namespace nullscope::cli
