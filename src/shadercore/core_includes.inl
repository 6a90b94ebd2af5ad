// What the shader core in either precision begins with. Its text leaves functions and parameters of some effects unused.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>

#include "shadercore/core_trace.h"

#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
