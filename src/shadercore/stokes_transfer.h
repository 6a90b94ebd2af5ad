// shaders/core/stokes_transfer.glsl in float: transfer of I, Q, U, V through matter that is even along a way.
#pragma once
#include <array>

namespace nullscope {

// Everything times the way: optical depth; what is absorbed of Q, U, V, of a length of `depth` at most; Faraday's conversion (Q, U) and
// rotation (V), rad.
struct StokesWay {
    float depth;
    std::array<float, 3> absorbed, turned;
};

using StokesRow = std::array<float, 4>;

// Of a detector that gets row.S of light S: what it gets of light j dl that is emitted evenly along the way, mean.j, and of light from behind it.
// Both within 1e-5 of |row| (tests/unit/test_stokes_transfer.cpp).
struct StokesSeen {
    StokesRow mean, behind;
};
StokesSeen stokes_seen(const StokesRow& row, const StokesWay& way);

}  // namespace nullscope
