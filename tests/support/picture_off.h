// How far two pictures of one size are apart.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "image/image.h"

namespace nullscope::test {

struct
    Off {  // of 255: mean of all channels; what a thousandth of the pixels exceeds, by their worst channel, and none does
    double mean = 0, thousandth = 0;
    int most = 0;
};

inline Off off_between(const Image<unsigned char>& a, const Image<unsigned char>& b) {
    std::vector<int> worst;
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); i += 3) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            const int off = std::abs(a.data[c] - b.data[c]);
            sum += off, most = std::max(most, off);
        }
        worst.push_back(most);
    }
    const int most = *std::ranges::max_element(worst);
    const auto at = worst.begin() + static_cast<std::ptrdiff_t>(worst.size() * 999 / 1000);
    std::nth_element(worst.begin(), at, worst.end());
    return {sum / static_cast<double>(a.data.size()), static_cast<double>(*at), most};
}

// Of linear light: the sum of the differences over that of `drawn`.
inline double light_off(const Image<float>& drawn, const Image<float>& other) {
    double sum = 0, whole = 0;
    for (std::size_t i = 0; i < drawn.data.size(); ++i)
        sum += std::fabs(other.data[i] - drawn.data[i]), whole += drawn.data[i];
    return sum / whole;
}

// Red of the pixels that are lit in both, brighter than `least` in `exact`: how far each is off, relative, ascending; and in how many `other`
// is off by more than `much`.
struct LitOff {
    std::vector<double> off;
    int changed = 0;
};
inline LitOff lit_against(const Image<float>& exact, double least, const Image<float>& picture,
                          const Image<float>& other, double much) {
    LitOff found;
    for (std::size_t i = 0; i < picture.data.size(); i += 3) {
        if (!(exact.data[i] > least) || !(picture.data[i] > 0)) continue;
        found.off.push_back(std::fabs(picture.data[i] / exact.data[i] - 1));
        found.changed += std::fabs(other.data[i] / exact.data[i] - 1) > much;
    }
    std::ranges::sort(found.off);
    return found;
}

}  // namespace nullscope::test
