#include "base/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "platform/console.h"

namespace nullscope {
namespace {

constexpr double kQuietSeconds = 0.5;     // work that is over by then needs no bar
constexpr double kTerminalSeconds = 0.1;  // fast enough to look alive
constexpr double kPlainSeconds = 3.0;     // slow enough not to fill a log
constexpr int kBarWidth = 30;             // columns; label, bar and times fit 80

}  // namespace

Progress::Progress(std::string label, long long total)
    : label_(std::move(label)),
      total_(std::max(total, 1LL)),
      terminal_(platform::is_terminal(platform::Output::kErrors)) {}

Progress::~Progress() {
    const std::lock_guard lock(mutex_);
    if (printed_) print(watch_.seconds(), true);
}

void Progress::advance(long long units) {
    done_ += units;
    const double elapsed_s = watch_.seconds();
    if (elapsed_s < kQuietSeconds) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || elapsed_s - last_print_s_ < (terminal_ ? kTerminalSeconds : kPlainSeconds)) return;
    print(elapsed_s, false);
}

void Progress::clear() {
    const std::lock_guard lock(mutex_);
    if (printed_ && terminal_) fmt::print(stderr, "\r\033[K");
}

// Called with mutex_ held.
void Progress::print(double elapsed_s, bool last) {
    const double fraction = std::clamp(static_cast<double>(done_.load()) / static_cast<double>(total_), 0.0, 1.0);
    const double left_s = fraction > 0.0 ? elapsed_s * (1.0 - fraction) / fraction : 0.0;
    const std::string times = last || fraction <= 0.0 ? fmt::format("{:.1f} s", elapsed_s)
                                                      : fmt::format("{:.1f} s, {:.0f} s left", elapsed_s, left_s);
    if (terminal_) {
        const auto filled = static_cast<std::size_t>(std::lround(fraction * kBarWidth));
        const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
        fmt::print(stderr, "\r{} [{}] {:3.0f}% {}\033[K{}", label_, bar, 100.0 * fraction, times, last ? "\n" : "");
    } else {
        fmt::print(stderr, "{}: {:.0f}% ({})\n", label_, 100.0 * fraction, times);
    }
    std::fflush(stderr);
    last_print_s_ = elapsed_s;
    printed_ = true;
}

Advance progress_on_terminal(const std::string& label, long long total) {
    return [progress = std::make_shared<Progress>(label, total)](long long units) { progress->advance(units); };
}

}  // namespace nullscope
