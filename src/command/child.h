// Work in processes of their own (platform/fork.h), with this program's errors.
#pragma once
#include <functional>

#include "base/result.h"
#include "platform/fork.h"

namespace nullscope::cli {

using platform::ChildAnswer;
using platform::write_all;

// platform::answer_of_child. Errors: no process could be made.
Result<ChildAnswer> answer_of_child(const std::function<int(int pipe)>& run, double limit_s);

}  // namespace nullscope::cli
