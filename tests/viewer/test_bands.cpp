// How a picture is cut into bands, from made-up costs: what the window may have to wait for, whatever a row costs.
#include <doctest/doctest.h>

#include <algorithm>

#include "studio/bands.h"

namespace {

using namespace nullscope::viewer;

struct Drawn {
    int bands = 0, rows = 0;
    double longest_ms = 0.0;  // band of those after the first
};

// Draws a picture whose row y costs row_ms(y).
template <class Cost>
Drawn draw(BandCutter& bands, Cost row_ms, double compile_ms = 0.0) {
    Drawn drawn;
    for (; !bands.done(); ++drawn.bands) {
        double ms = drawn.bands == 0 ? compile_ms : 0.0;
        CHECK(bands.first() % kBlockRows == 0);
        for (int y = bands.first(); y < bands.last(); ++y, ++drawn.rows) ms += row_ms(y);
        if (drawn.bands > 0) drawn.longest_ms = std::max(drawn.longest_ms, ms);
        bands.took(ms, drawn.bands == 0 && compile_ms > 0.0);
    }
    return drawn;
}

TEST_CASE("bands: every row is drawn once, and no band takes longer than it may") {
    for (const double row_ms : {0.0, 0.001, 0.1, 1.0, 7.0, 50.0}) {
        CAPTURE(row_ms);
        BandCutter unknown(720, 0.0);
        const Drawn first = draw(unknown, [&](int) { return row_ms; });
        CHECK(first.rows == 720);
        CHECK(first.longest_ms <= std::max(kBand_ms, kBlockRows * row_ms) * (1.0 + 1e-12));
        CHECK(unknown.row_ms() == doctest::Approx(row_ms));
        if (row_ms == 0.0) continue;
        BandCutter known(720, row_ms);
        const Drawn second = draw(known, [&](int) { return row_ms; });
        CHECK(second.rows == 720);
        CHECK(second.longest_ms <= std::max(kBand_ms, kBlockRows * row_ms) * (1.0 + 1e-12));
    }
}

TEST_CASE("bands: a picture like the one before is cut by its dearest row from the start") {
    const auto dear_above = [](int y) { return y < 300 ? 0.05 : 5.0; };
    BandCutter unknown(720, 0.0);
    draw(unknown, dear_above);
    CHECK(unknown.row_ms() == doctest::Approx(5.0));
    BandCutter known(720, unknown.row_ms());
    CHECK(known.last() == 4);
    CHECK(draw(known, dear_above).longest_ms <= kLongestBand * kBand_ms * (1.0 + 1e-12));
}

TEST_CASE("bands: what compiles is told from what draws") {
    BandCutter bands(720, 0.0);
    const Drawn drawn = draw(
        bands, [](int) { return 0.5; }, 400.0);
    CHECK(drawn.rows == 720);
    CHECK(bands.row_ms() == doctest::Approx(0.5));
    CHECK(bands.compile_ms() == doctest::Approx(400.0));
    BandCutter small(kFirstRows, 0.0);  // one band: nothing to judge it by
    draw(
        small, [](int) { return 0.5; }, 400.0);
    CHECK(small.row_ms() == 0.0);
    CHECK(small.compile_ms() == doctest::Approx(400.0 + 0.5 * kFirstRows));
}

}  // namespace
