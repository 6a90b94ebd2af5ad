// The shader core in double.
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
using Real = double;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core64(const CoreInput& input, double x, double y) { return dispatch(input, x, y); }

}  // namespace nullscope
