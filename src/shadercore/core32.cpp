// The shader core in float. Compiled with -fsingle-precision-constant, so that literals are float as in GLSL.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>

#include "shadercore/core_trace.h"

#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
namespace nullscope {
namespace {
using Real = float;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core32(const CoreInput& input, double x, double y) { return dispatch(input, x, y); }

}  // namespace nullscope
