// Rays about a rotating hole, which every pixel traces step by step in Mino's time (shaders/mino/kerr.glsl): nothing is built for
// them, the camera's frame is told as linear forms of the view direction.
#pragma once
#include "render/light_path.h"
#include "spacetime/axial_metric.h"

namespace nullscope {

class MinoPath final : public LightPath {
public:
    explicit MinoPath(std::shared_ptr<const AxialMetric> metric) : metric_(std::move(metric)) {}
    Start start(const FramePlan& plan, const Mat3& world) const override;
    RayNumbers ray_numbers(const FramePlan& plan, double theta, double phi, Vec3 n) const override;
    double ray_g(const FramePlan& plan, const FrameData& frame, const RayNumbers& ray, const ListedRay::Crossing& met,
                 Vec3 u) const override;
    PolarisedPhoton photon_of(const FrameData& frame, const RayNumbers& ray, const ListedRay::Crossing& met,
                              int number) const override;
    void write(const FramePlan& plan, FrameData& frame) const override;
    void give(const FramePlan& plan, CoreInput& input) const override;
    bool finds_star_images() const override { return true; }
    Status check(const Method& method, const FramePlan& plan) const override;

private:
    void write_ring(const FramePlan& plan, FrameData& frame) const;
    void write_near(const FramePlan& plan, FrameData& frame) const;
    std::shared_ptr<const AxialMetric> metric_;
};

}  // namespace nullscope
