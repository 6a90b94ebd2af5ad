// Where in a scene's picture what is seen moves to as a key of the scene grows: "what changes if the spin grows by 0.01?".
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "gradient/camera_view.h"

namespace nullscope {

class PictureMotion {
public:
    // key: of parameter_names() of rays. Errors: parse_parameters' and CameraView's; a metric without derivatives.
    static Result<std::unique_ptr<PictureMotion>> make(const Scene& scene, const std::string& key);

    struct Place {
        double right, down;   // px by one unit of the key (numbers, r_s, rad)
        double off_critical;  // px to the critical curve, by the first derivative; infinite where there is none
    };
    // x, y: px from the picture's upper left corner. Of what is seen first there: a place of the disc, else of the sky. n(x; p), what is seen at x for a
    // key of p, stays the same where x moves by -(dn/dx)^-1 dn/dp; both derivatives are those of ray_gradient(), and so is the error. Nothing: what falls
    // into the hole, and where the picture is folded (dn/dx has no inverse). Half a millisecond.
    std::optional<Place> at(double x, double y) const;

private:
    PictureMotion() = default;
    Scene scene_;
    ParameterKind kind_{};
    std::unique_ptr<Flow> flow_;
    std::optional<CameraView> view_;
};

}  // namespace nullscope
