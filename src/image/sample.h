// What the colours of a picture are.
#pragma once

namespace nullscope {

// Display-encoded (sRGB), whole numbers of 8 or 16 bits; or linear light, floats.
enum class Sample { kByte, kWord, kLight };

}  // namespace nullscope
