// The strip of shaders/core/strip.glsl: the deflection table's row for the camera's zeta0, as cubic polynomials.
#pragma once
#include <vector>

#include "shadercore/core_trace.h"
#include "table/ray_fan.h"

namespace nullscope {

struct TexelGrid {
    int width = 0, height = 0;
    std::vector<float> texels;   // RGBA
    TexelView view() const { return {texels.data(), width, height}; }
    std::size_t bytes() const { return texels.size() * sizeof(float); }
};

// Interpolation error at most 2e-8 (in cos phi and in sin phi / sin alpha) for w > w0. About 2 core-milliseconds.
TexelGrid build_strip(const RayFan& fan);

}  // namespace nullscope
