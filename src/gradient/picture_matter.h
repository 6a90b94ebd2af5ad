// The light of a scene's matter at places of its picture, and how it changes with keys of the scene; its flux. The images of what matter is do not have
// edges, but next to the critical curve their light has the logarithm of the distance from it: a spoke is cut there, its places move with the curve, and
// stand in pieces that are as many times as far from it as their neighbours.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gradient/camera_view.h"
#include "gradient/matter_ray.h"
#include "gradient/spoke_sum.h"

namespace nullscope {

class PictureMatter {
public:
    // Of the scene's matter alone: the sky counts as black. keys: parse_parameters() of light. Errors: MatterGlow's and CameraView's, those of check_medium(); a metric without
    // derivatives.
    static Result<std::unique_ptr<PictureMatter>> make(const Scene& scene, const std::vector<std::string>& keys);

    // Luminance of linear light, as the reference's pictures have it.
    struct Ray {
        double light, along;     // by the move of `at`, per px
        std::vector<double> by;  // by each key, the place in the picture kept
    };
    // As PictureLight's. faint: light that is off by 1e-6 of this may be.
    Ray at(double x, double y, double along_x, double along_y, double faint = 0) const;
    bool falls_in(double x, double y) const;
    // Of a place on the critical curve, px along this direction by each key.
    std::vector<double> critical_by(double x, double y, double along_x, double along_y) const;

    const std::vector<Parameter>& keys() const { return parameters_; }
    const Scene& scene() const { return scene_; }
    const CameraView& view() const { return *view_; }

private:
    PictureMatter() = default;
    Change change(const Parameter& key, const CameraView::Seen& seen) const;
    Scene scene_;
    std::vector<Parameter> parameters_;
    std::shared_ptr<const Flow> flow_;
    std::optional<CameraView> view_;
    std::unique_ptr<MatterGlow> glow_;
    double unit_ = 1;  // luminance of light 1
};

struct MatterFluxRule {
    int places = 6;  // in each piece of a spoke, of Gauss and Legendre
    double tolerance = 1e-3;
};
// As flux_gradient() of picture_flux.h.
Result<FluxGradient> flux_gradient(const PictureMatter& light, const MatterFluxRule& rule = {},
                                   const std::function<void(double)>& done = {});

}  // namespace nullscope
