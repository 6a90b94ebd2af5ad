// Loops over the texels of skies, compiled a second time for processors that add eight floats at once (AVX2), chosen when the program starts.
// The same operations in the same order, none fused: the same bits.
#pragma once

#ifdef NULLSCOPE_TARGET_CLONES
#define NULLSCOPE_WIDE_LANES __attribute__((target_clones("avx2", "default")))
#define NULLSCOPE_WITHIN_LANES \
    __attribute__((always_inline)) inline  // a function of its own would be compiled once, for the lesser one
#else
#define NULLSCOPE_WIDE_LANES
#define NULLSCOPE_WITHIN_LANES inline
#endif
