// The loop of Q and U of the scene in the window (compare/stokes_loop.h): whose light is followed, and what was found of it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/stokes_loop.h"
#include "scene/scene.h"
#include "scenefile/scene_text.h"

namespace nullscope::viewer {

// One orbit of the first hot spot, the last time an orbit after the first.
struct LoopOrder {
    static constexpr int kPoints = 121;
    Scene scene;  // of few pixels, without what a sum over them does not need
    double from = 0.0, period = 0.0;
    double time(int point) const { return from + period * point / (kPoints - 1); }
};

std::string no_loop(const Scene& scene);  // why it has none, or nothing
// Of the orbit that the scene's time is in, counted from time 0. Of a scene that has one.
LoopOrder loop_order(const Scene& scene);

class LoopWatch {
public:
    // A picture of this scene is on the screen. Another view forgets the loop once it rests: of pictures in motion only the time is taken. Another
    // orbit of the same view keeps it until there is a new one.
    void look(const Scene& scene, bool rests);
    std::optional<LoopOrder> take_order();  // once for each that look() found
    void take(StokesLoop part);             // points of the last order, from the first
    bool waits() const { return order_.has_value() || found_ < LoopOrder::kPoints; }  // once look() was called
    int found() const { return found_; }
    const StokesLoop& loop() const { return loop_; }  // whole, or of the first one as much as there is
    std::optional<StokesPoint> present() const;       // of a whole loop of this view, at the scene's time

private:
    std::vector<SceneLine> lines_;
    std::optional<LoopOrder> order_;  // that was not taken yet
    double from_ = 0.0, period_ = 0.0, time_ = 0.0;
    bool of_view_ = true;
    int found_ = LoopOrder::kPoints;
    StokesLoop loop_;
};

}  // namespace nullscope::viewer
