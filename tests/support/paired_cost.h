// What one way of drawing costs over another, on a machine that does other things too.
#pragma once
#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "gl/gl.h"

namespace nullscope::test {

struct PairedCost {
    double first_s, second_s;  // core-seconds, means
    double ratio;              // of the first to the second, the median over pairs
    double low, high;          // where that of endless pairs lies: below low in one of 1,000 runs, above high in one
};

template <class Draw>
double cost_of(const Draw& draw) {
    const auto seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    gl::finish();
    const double start = seconds();
    draw();
    gl::finish();
    return seconds() - start;
}

// Frames drawn one after the other, the order within a pair turned each time: what else the machine does strikes both of a pair alike, and
// a pair that it strikes unevenly moves the median by no more than its rank. before: called with true ahead of a first, not timed.
template <class First, class Second, class Before>
PairedCost paired_cost(int pairs, const First& first, const Second& second, const Before& before) {
    std::vector<double> ratios;
    double sums[2] = {0, 0};
    for (int i = 0; i < pairs; ++i) {
        double costs[2] = {0, 0};
        for (const bool is_first : {i % 2 == 0, i % 2 != 0}) {
            before(is_first);
            costs[is_first ? 0 : 1] = is_first ? cost_of(first) : cost_of(second);
        }
        ratios.push_back(costs[0] / costs[1]);
        sums[0] += costs[0], sums[1] += costs[1];
    }
    std::ranges::sort(ratios);
    // Half of the pairs lie above the true median, give or take 3.1 times sqrt(pairs)/2: ranks. Of fewer than 10 pairs, all.
    const int rank = std::max(0, static_cast<int>(0.5 * pairs - 1.55 * std::sqrt(pairs)));
    const auto at = [&](int i) { return ratios[static_cast<std::size_t>(i)]; };
    return {sums[0] / pairs, sums[1] / pairs, at(pairs / 2), at(rank), at(pairs - 1 - rank)};
}

template <class First, class Second>
PairedCost paired_cost(int pairs, const First& first, const Second& second) {
    return paired_cost(pairs, first, second, [](bool) {});
}

// A process now and then measures another cost than all others: the light-time table's share of a frame was 0.397 in one
// run, 0.116 to 0.135 in eleven (where its texels lie in memory, it seems). So a bound holds if one of a few tries, each
// with a renderer of its own, keeps it; what is dearer by itself is so in all of them. cost: gives a PairedCost and is called until
// its `low` keeps the bound: red is what is over it beyond doubt. Returns the last.
template <class Cost>
PairedCost within(double bound, const Cost& cost) {
    constexpr int kTries = 4;
    PairedCost last = cost();
    for (int i = 1; i < kTries && last.low > bound; ++i) last = cost();
    return last;
}

}  // namespace nullscope::test
