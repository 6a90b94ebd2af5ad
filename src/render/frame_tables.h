// What the CPU prepares for a frame: its plan, its light's path with its tables, and where a ball that moves is. No GL here: the
// shader core as C++ uses it too.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "render/ball_path.h"
#include "render/light_path.h"
#include "scene/frame_plan.h"
#include "shadercore/core_trace.h"

namespace nullscope {

// Keeps what can be kept from frame to frame.
class FrameTables {
public:
    // Errors: those of plan_frame and of ball_path; the frame before is still there then.
    Status update(const Scene& scene);

    const FramePlan& plan() const { return plan_; }  // of the last update
    const LightPath& path() const { return *path_; }
    const EffectSet& effects() const { return plan_.effects; }
    const Spacetime& spacetime() const { return *plan_.light; }  // of the rays
    const Spacetime& matter() const { return *plan_.matter; }    // of what they meet: another where light goes straight
    const TexelGrid* texels(std::string_view name) const;        // of LightPath::tables(); nullptr if it is not there
    // Of a ball that moves, else nullptr; made anew by every update.
    const BallPath* ball_path() const { return ball_path_ ? &*ball_path_ : nullptr; }
    void want_delays(bool wanted) { delays_wanted_ = wanted; }  // for ray data, whatever the scene
    int revision() const { return revision_; }                  // grows whenever a table changes

    // For the shader core as C++; views into this object.
    CoreInput core_input() const;

private:
    FramePlan plan_;
    std::unique_ptr<LightPath> path_;
    std::optional<BallPath> ball_path_;
    bool delays_wanted_ = false;
    int revision_ = 0;
};

}  // namespace nullscope
