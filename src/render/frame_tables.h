// What the CPU prepares for a frame: the spacetime's deflection table (once per spacetime), the strip and the orbit map (whenever
// the camera's radius changes), and the numbers of the uniform block (every frame). No GL here: the shader core as C++ uses it too.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "render/ball_path.h"
#include "scene/frame_plan.h"
#include "shadercore/core_trace.h"
#include "table/deflection_table.h"
#include "table/orbit_map.h"
#include "table/ray_fan.h"
#include "table/strip.h"

namespace nullscope {

// Keeps what can be kept from frame to frame.
class FrameTables {
public:
    // Errors: those of plan_frame and of ball_path; the frame before is still there then.
    Status update(const Scene& scene);

    const FramePlan& plan() const { return plan_; }  // of the last update
    const EffectSet& effects() const { return plan_.effects; }
    const Spacetime& spacetime() const { return *plan_.light; }  // of the rays
    const Spacetime& matter() const { return *plan_.matter; }    // of what they meet: another where light goes straight
    const DeflectionTable* table() const { return table_.get(); }  // nullptr in flat space
    const RayFan* fan() const { return fan_ ? &*fan_ : nullptr; }
    const TexelGrid& strip() const { return strip_.sky; }
    const TexelGrid& ends() const { return strip_.ends; }
    const TexelGrid& orbit_map() const { return orbit_map_.places; }
    const TexelGrid& delay_map() const { return orbit_map_.delays; }  // empty where nothing asks how long light takes
    const BallPath* ball_path() const {
        return ball_path_ ? &*ball_path_ : nullptr;
    }                                                           // of a ball that moves; made anew by every update
    void want_delays(bool wanted) { delays_wanted_ = wanted; }  // for ray data, whatever the scene
    const TexelGrid& star_lens() const { return star_lens_; }   // empty without point stars
    int revision() const { return revision_; }                  // grows whenever strip or orbit map change
    double table_ms() const { return table_ms_; }               // time of the last deflection table
    double rows_ms() const { return rows_ms_; }                 // time of the last strip and orbit map

    // For the shader core as C++; views into this object.
    CoreInput core_input() const;

private:
    RayFan camera_fan() const;
    void build_rows();

    FramePlan plan_;
    std::shared_ptr<const DeflectionTable> table_;
    std::optional<RayFan> fan_;
    Strip strip_;
    OrbitMap orbit_map_;
    TexelGrid star_lens_;
    std::optional<BallPath> ball_path_;
    bool delays_wanted_ = false;
    int revision_ = 0;
    double table_ms_ = 0.0, rows_ms_ = 0.0;
};

}  // namespace nullscope
