// Frames of ray data against the reference: lists of scenes, what is promised of them, and the judge of all such lists.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/draft.h"
#include "support/gpu_session.h"

namespace nullscope::test {

inline constexpr double kEveryRay_px = 0.05;  // what the project promises of every ray
inline constexpr double kNotHeld = std::numeric_limits<double>::infinity();

// Of every frame: no fate error, every number finite, and at most this, px.
struct Promise {
    double sky = kNotHeld, place = kNotHeld, swept = kNotHeld, g = kNotHeld;
    double of_width = 0;                          // px of a picture this wide; 0: the frame's own
    std::size_t least_skies = 0, least_hits = 0;  // pixels that have such a value in both frames
    bool which = false;                           // and of whose body each is, but for pixels that are forgiven
    double refine_above_px = kDisplaceAbove_px;   // measure_rays()
};

struct FrameCase {
    std::string name;
    Scene scene;
};

class AgainstReference {
public:
    AgainstReference(std::string topic, const Promise& promise) : topic_(std::move(topic)), promise_(promise) {}
    // Draws, prints and checks one frame of every row_step-th row; nothing is measured, and nothing given back, where one of this
    // name had the same bits before.
    std::optional<RayMeasures> frame(GpuSession& session, const std::string& name, const Scene& scene,
                                     int row_step = 1);
    const RayFrame& drawn() const { return drawn_; }  // by the last frame()
    void frames(GpuSession& session, Selection selection, const std::vector<FrameCase>& cases);

private:
    std::string topic_;
    Promise promise_;
    MeasuredOnce measured_;
    RayFrame drawn_;
};

// Of the sky's directions in two frames inside their margins, px of 1080p: where it turns fast with the pixel, of as much less.
struct Apart {
    double most_px = 0;
    int fates = 0, skies = 0;
};
Apart apart(const RayFrame& one, const RayFrame& other, const CameraSpec& camera);

}  // namespace nullscope::test
