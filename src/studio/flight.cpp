#include "studio/flight.h"

#include <utility>

namespace nullscope::viewer {

std::optional<bool> Flight::follow(const ViewState& view) {
    const bool had_path = timeline.has_path(), another = source_ != view.source;
    timeline.follow(view.scene, another);
    source_ = view.source;
    if (timeline.has_path() == had_path && !another) return std::nullopt;
    return timeline.has_path();
}

bool Flight::sample(const Scene& scene, double now) {
    const double since = now - std::exchange(sampled_at_, now);
    return timeline.sample(scene, since);
}

}  // namespace nullscope::viewer
