// The uniform block of shaders/shared/frame_block.glsl as C++: the struct is that file itself, so its members have the
// names that shaders read, and a number is put where it belongs by name.
#pragma once
#include <array>
#include <bit>
#include <cstddef>

#include "base/vec.h"

namespace nullscope {

// The file declares its members for the effects that are on; here all are there (the build leaves out the file's #ifdef lines), in
// the order of the file. vec4: the vector that they are of.
template <class vec4>
struct FrameBlock {
#include "shadercore/frame_block.inl"
};

struct FrameVector {
    double x = 0, y = 0, z = 0, w = 0;
    constexpr FrameVector() = default;
    constexpr FrameVector(double first, double second, double third, double fourth)
        : x(first), y(second), z(third), w(fourth) {}
    constexpr FrameVector(Vec3 v, double fourth) : x(v.x), y(v.y), z(v.z), w(fourth) {}
};

// What the host works out for a frame: in double, all members, 0 where nothing was put.
using FrameData = FrameBlock<FrameVector>::FrameData;
inline constexpr std::size_t kFrameVectors = sizeof(FrameData) / sizeof(FrameVector);
static_assert(sizeof(FrameVector) == 4 * sizeof(double) && sizeof(FrameData) == kFrameVectors * sizeof(FrameVector));

// The members in the order of the file.
using FrameVectors = std::array<FrameVector, kFrameVectors>;
inline FrameVectors vectors_of(const FrameData& frame) { return std::bit_cast<FrameVectors>(frame); }

}  // namespace nullscope
