// nullscope bench frames --effects: what each effect costs, added alone to a scene that does without it.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::cli {

// Prints one line an effect and, if json names a file, writes the rows there. Every effect is drawn in turn with the scene without
// it (A B A B ...). Errors: no context, a file that cannot be written.
Status bench_effects(const std::string& context, int width, int height, int frames, const std::string& json);

}  // namespace nullscope::cli
