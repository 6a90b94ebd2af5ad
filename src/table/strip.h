// The strip of shaders/core/strip.glsl: the deflection table's row for the camera's zeta0.
#pragma once
#include <vector>

#include "shadercore/core_trace.h"
#include "table/ray_family.h"

namespace nullscope {

struct TexelGrid {
    int width = 0, height = 0;
    std::vector<float> texels;  // RGBA
    TexelView view() const { return {texels.data(), width, height}; }
    std::size_t bytes() const { return texels.size() * sizeof(float); }
};

struct Strip {
    TexelGrid
        sky;  // cos(phi) and sin(phi)/sin(alpha) of the rays that reach the sky, then of the others if they end somewhere to see, then
              // of those again by their angle from the centre if they come back (shaders/core/strip.glsl)
    TexelGrid ends;  // phi_end/sin(alpha) of all rays; those of `sky` again, as cubics (rows of core/strip.glsl)
};

// Error of cos(phi) and of sin(phi): (1/1024)^2/16 of the second derivative by ln w, at most 6e-7, where the sky moves by 1 rad
// per rad; less in pixels towards the critical ray. About 1 core-millisecond.
Strip build_strip(const RayFamily& family);

}  // namespace nullscope
