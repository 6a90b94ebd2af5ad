// The size of pictures in motion on machines that are simulated: a picture takes what its pixels take, and a wait for the window.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "studio/motion_size.h"

namespace {

using namespace nullscope::viewer;

struct Machine {
    double alone_ms;          // of a picture as large as the window
    double wait_ms;           // for the window, of a smaller one, which has to be stretched
    double whole_wait_ms;     // of one as large
    bool knows_alone = true;  // it was drawn by itself
    bool matter = false;
    double ms(double times) const {
        return alone_ms / (matter ? times : times * times) + (times > 1.0 ? wait_ms : whole_wait_ms);
    }
};

struct Flight {
    double times = 0.0, ms = 0.0;  // the median of what it came to
    int changes = 0;               // of the size, in the last hundred pictures
};

Flight flown(const Machine& machine) {
    MotionSize size;
    std::mt19937 random(3);
    std::vector<double> times, ms;
    double last_ms = 0.0;
    int changes = 0;
    for (int i = 0; i < 200; ++i) {
        const double next = size.next({last_ms, machine.knows_alone ? machine.alone_ms : 0.0, machine.matter});
        CHECK(next >= 1.0);
        CHECK(next <= 8.0);
        const double noise = std::uniform_real_distribution(0.9, 1.1)(random);
        last_ms = noise * machine.ms(next);
        if (i < 100) continue;
        changes += !times.empty() && times.back() != next ? 1 : 0;
        times.push_back(next), ms.push_back(machine.ms(next));
    }
    const auto median = [](std::vector<double>& values) {
        std::ranges::nth_element(values, values.begin() + 50);
        return values[50];
    };
    return {median(times), median(ms), changes};
}

TEST_CASE("motion size: pictures take the time that they may, whatever the window takes beside them") {
    for (const double alone_ms : {50.0, 75.0, 150.0, 400.0})
        for (const double wait_ms : {0.5, 8.0, 18.0}) {
            CAPTURE(alone_ms);
            CAPTURE(wait_ms);
            const Flight flight = flown({alone_ms, wait_ms, 0.5 * wait_ms});
            CHECK(flight.ms <= kMotion_ms);
            CHECK(flight.ms >= 0.54 * kMotion_ms);  // the next finer has 1.25^2 the pixels, and may take 0.85
            CHECK(flight.changes <= 10);
        }
}

TEST_CASE("motion size: what is drawn soon enough is drawn as large as the window") {
    const Flight flight = flown({30.0, 18.0, 8.0});
    CHECK(flight.times == 1.0);
    CHECK(flight.changes == 0);
    CHECK(flown({3.0, 18.0, 8.0}).times == 1.0);
}

TEST_CASE("motion size: a picture that takes long only while it moves becomes smaller and stays so") {
    const Flight flight = flown({30.0, 18.0, 40.0});
    CHECK(flight.times > 1.0);
    CHECK(flight.changes <= 10);
}

TEST_CASE("motion size: without a picture drawn by itself sizes go by the last one's time") {
    const Flight flight = flown({100.0, 2.0, 1.0, false});
    CHECK(flight.ms <= kMotion_ms);
    CHECK(flight.ms >= 0.4 * kMotion_ms);
    CHECK(flown({10.0, 2.0, 1.0, false}).times == 1.0);
    const Flight matter = flown({200.0, 2.0, 1.0, true, true});
    CHECK(matter.ms <= kMotionInMatter_ms);
    CHECK(matter.ms >= 0.4 * kMotionInMatter_ms);
}

TEST_CASE("motion size: what is dearer than it was by itself, as a view near the hole, is drawn smaller") {
    MotionSize size;
    double last_ms = 0.0, times = 1.0;
    for (int i = 0; i < 60; ++i) {
        times = size.next({last_ms, 75.0, false});
        last_ms = 4.0 * 75.0 / (times * times) + 15.0;
    }
    CHECK(last_ms <= 1.3 * kMotion_ms);
    CHECK(times < 8.0);
}

TEST_CASE("motion size: what is cheaper than it was by itself, as a view of the sky alone, is drawn larger") {
    MotionSize size;
    double last_ms = 0.0, times = 1.0;
    for (int i = 0; i < 60; ++i) {
        times = size.next({last_ms, 110.0, false});
        last_ms = 0.4 * 110.0 / (times * times) + (times > 1.0 ? 3.0 : 1.0);
    }
    CHECK(times < 1.5);  // 1.7 and more by what it took alone
    CHECK(last_ms <= 1.2 * kMotion_ms);
}

}  // namespace
