#include "platform/failure_box.h"

namespace nullscope::platform {

void show_failure(const std::string&, const std::string&) {}

}  // namespace nullscope::platform
