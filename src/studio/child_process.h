// A program that runs beside the viewer, and what it prints.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "platform/process.h"

namespace nullscope::viewer {

class ChildProcess : public platform::Program {
public:
    // As Program's. Errors: it cannot be started.
    Status start(std::vector<std::string> words) {
        const std::string why_not = Program::start(std::move(words));
        return why_not.empty() ? Status(Done{}) : failed(why_not);
    }
};

}  // namespace nullscope::viewer
