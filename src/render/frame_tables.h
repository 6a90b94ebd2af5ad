// What the CPU prepares for a frame: its plan, its light's path with its tables, where the balls that move are and what is empty about
// solids by formula. No GL here: the
// shader core as C++ uses it too.
#pragma once
#include <memory>

#include "base/result.h"
#include "plan/frame_plan.h"
#include "render/ball_paths.h"
#include "render/light_path.h"
#include "shadercore/core_trace.h"
#include "table/surface_clearance.h"

namespace nullscope {

// Keeps what can be kept from frame to frame.
class FrameTables {
public:
    // Errors: those of plan_frame and of ball_paths; the frame before is still there then.
    Status update(const Scene& scene);

    const FramePlan& plan() const { return plan_; }  // of the last update
    const LightPath& path() const { return *path_; }
    const EffectSet& effects() const { return plan_.effects; }
    const Spacetime& spacetime() const { return *plan_.light; }  // of the rays
    const Spacetime& matter() const { return *plan_.matter; }    // of what they meet: another where light goes straight
    const TexelGrid* texels(std::string_view name) const;        // of LightPath::tables(); nullptr if it is not there
    const BallPaths& ball_paths() const { return ball_paths_; }  // made anew by every update
    const SurfaceClearances& clearances() const { return clearances_; }
    int clearances_revision() const { return clearances_revision_; }  // grows whenever they change
    void want_delays(bool wanted) { delays_wanted_ = wanted; }        // for ray data, whatever the scene
    void want_crossings(bool wanted) {
        crossings_wanted_ = wanted;
    }                                                      // of the plane of discs, whether there is one or not
    void pass_crossings(int number) { passed_ = number; }  // that a ray makes before the disc counts
    void follow_camera(bool wanted = true) { follows_camera_ = wanted; }  // LightPath::follows_camera
    int revision() const { return revision_; }                            // grows whenever a table changes

    // For the shader core as C++; views into this object.
    CoreInput core_input() const;
    // Rays of a list through it, on all cores; as many answers as rays.
    void list_rays(bool in_double, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                   ListedRay* found) const;

private:
    FramePlan plan_;
    std::unique_ptr<LightPath> path_;
    BallPaths ball_paths_;
    SurfaceClearances clearances_;
    bool delays_wanted_ = false, crossings_wanted_ = false, follows_camera_ = false;
    int passed_ = 0, revision_ = 0, clearances_revision_ = 0;
};

}  // namespace nullscope
