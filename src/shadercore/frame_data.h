// The uniform block of shaders/shared/frame_block.glsl as C++: the struct is that file itself, so its members have the
// names that shaders read, and a number is put where it belongs by name.
#pragma once
#include <array>
#include <bit>
#include <cstddef>

#include "base/vec.h"

namespace nullscope {

// The file declares its members for the effects that are on; here all are there, in the order of the file. vec4: the
// vector that they are of.
template <class vec4>
struct FrameBlock {
#define BLOCK_LENSING
#define BLOCK_ABERRATION
#define BLOCK_SKY
#define BLOCK_SKY_SHIFT
#define BLOCK_DISC
#define BLOCK_THERMAL_DISC
#define BLOCK_POINT_STARS
#define BLOCK_BLOOM
#define BLOCK_SPHERE
#define BLOCK_CYLINDER
#define BLOCK_BALL
#define BLOCK_SURFACE
#define BLOCK_MARCH
#define BLOCK_DISC_PATTERN
#define BLOCK_SKY_PATTERN
#define BLOCK_DELAY
#define BLOCK_DISC_FLOW
#define BLOCK_SPOT
#define BLOCK_BALL_PATH
#define BLOCK_SPIN
#define BLOCK_SIDES
#include "shared/frame_block.glsl"
#undef BLOCK_LENSING
#undef BLOCK_ABERRATION
#undef BLOCK_SKY
#undef BLOCK_SKY_SHIFT
#undef BLOCK_DISC
#undef BLOCK_THERMAL_DISC
#undef BLOCK_POINT_STARS
#undef BLOCK_BLOOM
#undef BLOCK_SPHERE
#undef BLOCK_CYLINDER
#undef BLOCK_BALL
#undef BLOCK_SURFACE
#undef BLOCK_MARCH
#undef BLOCK_DISC_PATTERN
#undef BLOCK_SKY_PATTERN
#undef BLOCK_DELAY
#undef BLOCK_DISC_FLOW
#undef BLOCK_SPOT
#undef BLOCK_BALL_PATH
#undef BLOCK_SPIN
#undef BLOCK_SIDES
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
