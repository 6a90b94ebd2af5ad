// Rays that stay in a plane: the spacetime's deflection table (once), then for the camera's radius and frame the strip, the orbit
// map, the light-time table and the star lens, as far as the frame's effects ask for them.
#pragma once
#include <optional>

#include "render/light_path.h"
#include "spacetime/spherical_metric.h"
#include "table/orbit_map.h"

namespace nullscope {

class PlanarPath final : public LightPath {
public:
    explicit PlanarPath(std::shared_ptr<const SphericalMetric> metric);
    bool update(const FramePlan& plan) override;
    Start start(const FramePlan& plan, const Mat3& world) const override;
    void write(const FramePlan& plan, FrameData& frame) const override;
    void give(CoreInput& input) const override;
    std::vector<NamedTexels> tables() const override;
    const RayFan* fan() const override { return fan_ ? &*fan_ : nullptr; }
    const DeflectionTable* table() const override { return table_.get(); }
    Status check(const Method& method, const FramePlan& plan) const override;

    // What of the rows an effect set asks for.
    struct Rows {
        bool orbits = false, delays = false, points = false;
    };

private:
    RayFan camera_fan(const FramePlan& plan) const;
    void build(const FramePlan& plan);

    std::shared_ptr<const SphericalMetric> metric_;
    std::shared_ptr<const DeflectionTable> table_;  // nullptr where there is no angle chi
    std::optional<RayFan> fan_;
    Rows rows_;  // that are there
    Strip strip_;
    OrbitMap orbit_map_;
    TexelGrid star_lens_;
};

}  // namespace nullscope
