// What every proof reads from the environment.
//   NULLSCOPE_SEED=n   another set of random cases than the fixed one; failures print the seed
//   NULLSCOPE_LONG=n   n times as many of them
#pragma once
#include <cmath>
#include <cstdlib>
#include <random>

#include "support/depth.h"

namespace nullscope::proof {

inline unsigned seed() {
    const char* text = std::getenv("NULLSCOPE_SEED");
    return text != nullptr ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 20240229u;
}
inline int times_longer() {
    const char* text = std::getenv("NULLSCOPE_LONG");
    const int n = text != nullptr ? std::atoi(text) : 1;
    return n > 1 ? n : 1;
}
// Of so many random cases, how many are tried: a third at quick depth.
inline int tries(int cases, const char* file = __builtin_FILE()) {
    return cases * times_longer() / test::by_depth(3, 1, 1, file);
}

// Random numbers that are the same with every standard library (its distributions are not).
class Random {
public:
    explicit Random(unsigned from) : engine_(from) {}
    double unit() { return (static_cast<double>(engine_()) + 0.5) / 4294967296.0; }  // (0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    double log_between(double low, double high) { return low * std::pow(high / low, unit()); }
    int below(int count) { return static_cast<int>(unit() * count); }

private:
    std::mt19937 engine_;
};

}  // namespace nullscope::proof
