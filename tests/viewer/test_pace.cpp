// What the viewer's loop keeps: when it waits, how motion is timed, how messages end, when it measures.
#include <doctest/doctest.h>

#include <cmath>

#include "studio/adaptation.h"
#include "studio/effect_watch.h"
#include "studio/message.h"
#include "studio/pace.h"
#include "studio/picture_rate.h"

using namespace nullscope::viewer;

TEST_CASE("pace: the loop waits for what comes first") {
    Pace pace;
    LoopWork work;
    CHECK(pace.wait(work, 1.0) == 0.0);  // the first frames are due
    work.painting = true;
    CHECK(pace.wait(work, 1.0) == 0.0);  // nothing was drawn yet
    for (int frame = 0; frame < kSettlingFrames; ++frame) pace.drawn(1.0);
    CHECK(pace.frames() == kSettlingFrames);
    CHECK(pace.wait(work, 1.0) == kProgressWait);
    pace.want(1);
    CHECK(pace.wait(work, 1.0 + 0.25 * kBusyWait) == doctest::Approx(0.75 * kBusyWait));
    CHECK(pace.wait(work, 2.0) == 0.0);
    pace.drawn(2.0);
    work.painting = false;
    CHECK(pace.wait(work, 2.0) == kIdleWait);
    work.next = 0.3;
    CHECK(pace.wait(work, 2.0) == 0.3);
    work.adapting = true;
    CHECK(pace.wait(work, 2.0) == kAdaptingWait);
    work.caret = true;
    CHECK(pace.wait(work, 2.0) == kCaretWait);
    work.in_motion = true;
    CHECK(pace.wait(work, 2.0) == 0.0);
    work.minimised = true;
    CHECK(pace.wait(work, 2.0) == kIdleWait);
}

TEST_CASE("pace: frames that are wanted are never fewer") {
    Pace pace;
    for (int frame = 0; frame < 9; ++frame) pace.drawn(1.0);  // as those that nothing was due for
    CHECK_FALSE(pace.due());
    pace.want(2);
    pace.want(1);
    pace.drawn(1.0);
    CHECK(pace.due());
    pace.drawn(1.0);
    CHECK_FALSE(pace.due());
}

TEST_CASE("pace: neither a wait nor a hitch is a leap") {
    Pace pace;
    CHECK(pace.begin_turn(100.0, false) == kLongestFrameStep);
    CHECK(pace.begin_turn(100.02, false) == doctest::Approx(0.02));
    CHECK(pace.begin_turn(107.0, true) == kFirstStep);
}

TEST_CASE("pace: a rate is that of pictures that follow each other") {
    PictureRate rate;
    rate.shown(10.0, false, 40.0);
    CHECK(rate.fps() == 0.0);
    CHECK(rate.picture_ms() == 40.0);
    for (int i = 1; i <= 20; ++i) rate.shown(10.0 + 0.05 * i, true, {});
    CHECK(rate.fps() == doctest::Approx(20.0));
    CHECK(rate.picture_ms() == 40.0);  // of the last whole one
    rate.shown(30.0, false, 60.0);
    CHECK(rate.fps() == 0.0);
    CHECK(rate.picture_ms() == 60.0);
}

TEST_CASE("pace: exposure comes to rest") {
    Adaptation adaptation;
    CHECK_FALSE(adaptation.goes_on());
    adaptation.begin();
    CHECK(adaptation.goes_on());
    (void)adaptation.step(1.0, false);
    CHECK(adaptation.step(1.05, false) == doctest::Approx(1.0 - std::exp(-0.05 / Adaptation::kTime_s)));
    int pictures = 0;
    for (double now = 1.1; adaptation.goes_on(); now += 0.05) (void)adaptation.step(now, false), ++pictures;
    CHECK(pictures > 40);
    CHECK(pictures < 60);  // ln(1/kAdapted) kTime_s / 0.05 s
    adaptation.begin();
    CHECK(adaptation.step(9.0, true) == 1.0);
    CHECK_FALSE(adaptation.goes_on());
}

TEST_CASE("pace: a message ends once, and says how long it has") {
    Message message;
    CHECK_FALSE(message.ends(1e9));
    CHECK(std::isinf(message.left(0.0)));
    message.say("Saved", 5.0);
    CHECK(message.left(6.0) == doctest::Approx(Message::kTime_s - 1.0));
    CHECK_FALSE(message.ends(6.0));
    CHECK(message.text() == "Saved");
    CHECK(message.ends(5.1 + Message::kTime_s));
    CHECK(message.text().empty());
    CHECK_FALSE(message.ends(99.0));
}

TEST_CASE("pace: effects are measured once for each picture, after a rest") {
    EffectWatch watch;
    watch.begin(10.0);
    CHECK_FALSE(watch.asks(10.2));
    CHECK(watch.wait(10.2) == doctest::Approx(EffectWatch::kRest_s - 0.2));
    CHECK(watch.asks(10.6));
    CHECK_FALSE(watch.asks(11.0));
    CHECK(std::isinf(watch.wait(11.0)));
    watch.take({{}, 3.0, true});
    CHECK(watch.times().complete);
    watch.begin(12.0);
    CHECK_FALSE(watch.times().complete);
    CHECK(watch.asks(12.6));
}
