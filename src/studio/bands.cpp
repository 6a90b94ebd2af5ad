#include "studio/bands.h"

#include <algorithm>

namespace nullscope::viewer {
namespace {

constexpr double kLeastRow_ms = 1e-6;  // a clock may not see a row's time at all

int affordable(double row_ms, int height) {
    const double blocks = kBand_ms / (kBlockRows * std::max(row_ms, kLeastRow_ms));
    return kBlockRows * static_cast<int>(std::clamp(blocks, 1.0, static_cast<double>(height)));
}

}  // namespace

BandCutter::BandCutter(int height, double row_ms)
    : height_(height),
      last_(std::min(row_ms > 0.0 ? affordable(row_ms, height) : kFirstRows, height)),
      expected_ms_(row_ms / kLongestBand) {}

void BandCutter::took(double ms, bool compiled) {
    const int rows = last_ - first_;
    if (compiled) {
        compile_ms_ += ms;
        compiled_rows_ += rows;
    } else {
        const double row_ms = ms / rows;
        dearest_ms_ = std::max(dearest_ms_, row_ms);
        compile_ms_ = std::max(compile_ms_ - compiled_rows_ * row_ms, 0.0);
        compiled_rows_ = 0;
    }
    const int next = compiled ? rows : std::min(affordable(std::max(dearest_ms_, expected_ms_), height_), 2 * rows);
    first_ = last_;
    last_ = std::min(first_ + next, height_);
}

}  // namespace nullscope::viewer
