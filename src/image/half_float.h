// Half floats (IEEE 754 binary16) as bits. Without branches, so that loops over it are vectorised.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace nullscope {

// The rounding of a float that is not negative to a small one of five bits of exponent, as OpenGL has them: kCut bits of its mantissa are
// rounded off, to the nearest, halves to even; below 2^-14 steps stay what they are there. NaN and what is below 0 become 0, what is beyond
// `most`, the largest of them, this.
template <int kCut>
inline std::uint32_t small_float(float value, float most) {
    constexpr std::int32_t kRebias = 112 << 23, kLeast = kRebias + (1 << 23);  // of exponents; bits of 2^-14
    constexpr float kSteps = static_cast<float>(1 << (14 + 23 - kCut));        // in 1
    const float positive = value > 0.0f ? value : 0.0f;                        // NaN too
    const float within = positive < most ? positive : most;
    const auto bits = std::bit_cast<std::int32_t>(within);
    const auto fine =
        static_cast<std::int32_t>((bits < kLeast ? within : 0.0f) * kSteps + 0.5f);  // NOLINT: below 2^10, above 0
    const std::int32_t rounded = bits - kRebias + (1 << (kCut - 1)) - 1 + (bits >> kCut & 1);
    return static_cast<std::uint32_t>(bits >= kLeast ? rounded >> kCut : fine);
}

inline constexpr float kMostHalf = 65504.0f;
inline std::size_t count_beyond_half(std::span<const float> light) {
    return static_cast<std::size_t>(std::ranges::count_if(light, [](float x) { return x > kMostHalf; }));
}
inline std::uint32_t half_bits(float light) { return small_float<13>(light, kMostHalf); }

}  // namespace nullscope
