// The camera's boost in words.
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope::viewer {

// "0.5 c, outward and east, against an observer at rest here": directions of more than a tenth of the speed, the largest first.
std::string boost_words(const CameraSpec& camera);

}  // namespace nullscope::viewer
