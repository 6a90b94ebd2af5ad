// The disc's light at places of a scene's picture, and how it changes with keys of the scene: what a picture's pixels, a fit or a flux are made of.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gradient/camera_view.h"
#include "gradient/disc_glow.h"

namespace nullscope {

class PictureLight {
public:
    // Of the scene's thermal disc alone: the sky counts as black. keys: parse_parameters() of light; none: values alone. Errors:
    // DiscGlow's and CameraView's; a metric without derivatives.
    // tolerance: of a ray's step, values and derivatives.
    static Result<std::unique_ptr<PictureLight>> make(const Scene& scene, const std::vector<std::string>& keys,
                                                      double tolerance = 1e-10);

    // Of a number where a ray is: by the move of `at`, per px, and by each key.
    struct Varied {
        double value, along;
        std::vector<double> by;
    };
    struct Crossing {
        Varied r;          // r_s
        Varied luminance;  // of what it adds to the light: linear, of what is before it dimmed
    };
    struct Ray {
        Vec3 light;                       // linear Rec. 709, as the reference's pictures have it
        std::vector<Vec3> by;             // by each key, the place in the picture kept
        std::vector<Crossing> crossings;  // of the disc's plane, within farthest() r_s
        double
            off_edge;  // px to the critical curve or to a rim's image, by the first derivative: the derivatives hold for less
    };
    // x, y: px from the picture's upper left corner. along_x, along_y: unit vector of the picture, y downward. A fifth of a millisecond.
    Ray at(double x, double y, double along_x = 1, double along_y = 0) const;
    bool falls_in(double x, double y) const;  // some 40 microseconds

    const std::vector<Parameter>& keys() const { return parameters_; }
    const Scene& scene() const { return scene_; }
    const CameraView& view() const { return *view_; }
    bool has_horizon() const { return flow_->has_horizon(); }
    const std::vector<LightMark>& marks() const { return marks_; }
    double emissivity(double r) const { return glow_->emissivity(r); }
    // Of a mark, by each key.
    std::vector<double> mark_by(const LightMark& mark) const;
    static constexpr int kOrders = 4;  // crossings whose light counts; what is left out is e^(-4 pi) of it

private:
    PictureLight() = default;
    Scene scene_;
    double tolerance_ = 0;
    std::vector<Parameter> parameters_;
    std::shared_ptr<const Flow> flow_;
    std::optional<CameraView> view_;
    std::unique_ptr<DiscGlow> glow_;
    std::vector<LightMark> marks_;
};

// The metric's numbers that a scene does not give are the registry's. Errors: make_flow's.
Result<std::unique_ptr<Flow>> flow_of(const SpacetimeSpec& spacetime);

}  // namespace nullscope
