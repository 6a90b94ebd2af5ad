// The scene's path: played, recorded from what is flown, filmed.
#pragma once
#include <optional>
#include <string>

#include "studio/film_export.h"
#include "studio/timeline.h"
#include "studio/view_state.h"

namespace nullscope::viewer {

class Flight {
public:
    Timeline timeline;
    FilmExport film;

    // The scene's path may be new, or gone. Whether there is one, if that has changed or the scene is another.
    std::optional<bool> follow(const ViewState& view);
    // now: s of a steady clock, here and below.
    void record(const Scene& scene, double now) { timeline.record(scene), sampled_at_ = now; }
    // Of what is flown, while it is recorded. False: another observer, with whom the record begins anew.
    bool sample(const Scene& scene, double now);

private:
    std::string source_;  // of the scene that the timeline knows
    double sampled_at_ = 0.0;
};

}  // namespace nullscope::viewer
