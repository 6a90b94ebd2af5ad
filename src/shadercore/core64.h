// The pure functions of shaders/core that the host itself needs, in double: the table's mapping.
#pragma once
#include <cmath>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace nullscope::core64 {
namespace {
using std::sqrt;
#define float double
#include "core/table_mapping.glsl"
#undef float
}  // namespace
}  // namespace nullscope::core64
#pragma GCC diagnostic pop
