// Visibilities of light at places of any kind: V(u, v) = sum of I e^(2 pi i (u l + v m)), as telescope/visibility.h has it.
#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "telescope/visibility.h"

namespace nullscope {

class LightPoints {
public:
    explicit LightPoints(int planes) : planes_(planes) {}  // 1, or 4: I, Q, U, V
    // light: of each plane. l, m: rad, to the east and to the north. odd: of two halves, each every second place, which one it belongs to.
    // Dark places are left out.
    void add(double l, double m, const std::array<double, 4>& light, bool odd);

    // change: if the even half stood for both. Within 1e-9 of the light. Cost: 10 ns a place.
    VisibilitySum at(Baseline baseline) const;
    double whole() const;  // of plane I

    void scale(double factor);

private:
    struct Half {
        std::size_t count = 0;
        std::vector<double> l, m;
        std::array<std::vector<double>, 4> light;
    };
    Visibility sum(const Half& half, Baseline baseline) const;
    int planes_;
    std::array<Half, 2> halves_;
};

}  // namespace nullscope
