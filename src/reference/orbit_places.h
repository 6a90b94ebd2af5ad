// Places along an orbit that is looked along for bodies.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "reference/orbit.h"

namespace nullscope::reference {

// As Orbit::zeta_at, and where looks crowd, by sums of Chebyshev's polynomials through places of the orbit: to 1e-11 of the place; in
// wormholes, where places are l, of the largest one in the eighth of a radian around. Some 20 ns a place of a sum. For looks: what they find
// is asked of the orbit itself.
class OrbitPlaces {
public:
    OrbitPlaces(const Orbit& orbit, bool by_length) : orbit_(orbit), by_length_(by_length) {}
    double operator()(double angle);

private:
    static constexpr std::size_t kTerms = 16;
    struct Stretch {
        enum class Kind : unsigned char { kAsked, kSummed, kNoSum };
        Kind kind = Kind::kAsked;
        unsigned asked = 0;
        std::array<double, kTerms> terms{};
    };
    void sum(Stretch& stretch, double from) const;
    const Orbit& orbit_;
    bool by_length_;
    std::vector<Stretch> stretches_;  // of equal angles, from 0 on
};

}  // namespace nullscope::reference
