// Rays that stay in a plane: the spacetime's deflection table (once), then for the camera's radius and frame the strip, the orbit
// map, the light-time table and the star lens, as far as the frame's effects ask for them.
#pragma once
#include <optional>

#include "render/light_path.h"
#include "spacetime/spherical_metric.h"
#include "table/camera_tables.h"

namespace nullscope {

class PlanarPath final : public LightPath {
public:
    explicit PlanarPath(std::shared_ptr<const SphericalMetric> metric);
    bool update(const FramePlan& plan) override;
    void write(const FramePlan& plan, FrameData& frame) const override;
    void give(const FramePlan& plan, CoreInput& input) const override;
    std::vector<NamedTexels> tables() const override;
    const RayFamily* family() const override { return family_ ? &*family_ : nullptr; }
    const DeflectionTable* table() const override { return table_.get(); }
    Status check(const Method& method, const FramePlan& plan) const override;

    // What an effect set asks for.
    struct Rows {
        WantedTables tables;
        bool points = false;
        friend bool operator==(const Rows&, const Rows&) = default;
    };

private:
    RayFamily camera_family(const FramePlan& plan) const;
    void build(const FramePlan& plan);

    std::shared_ptr<const SphericalMetric> metric_;
    std::shared_ptr<const DeflectionTable> table_;  // nullptr where there is no angle chi
    std::optional<RayFamily> family_;
    Rows rows_;  // that are there
    CameraTables tables_;
    std::optional<RadiusSteps> steps_;  // while it follows a camera
    TexelGrid star_lens_;
};

}  // namespace nullscope
