// Where in a scene's picture what is seen moves to as a key of the scene grows: "what changes if the spin grows by 0.01?".
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gradient/camera_view.h"

namespace nullscope {

class PictureMotion {
public:
    // keys: of parameter_names() of rays. Errors: parse_parameters' and CameraView's; a metric without derivatives.
    static Result<std::unique_ptr<PictureMotion>> make(const Scene& scene, const std::vector<std::string>& keys);

    // By one unit of a key (numbers, r_s, rad), at a place of the picture.
    struct ByKey {
        // Where what is seen first there, a place of the disc, else of the sky, moves to, px: n(x; p), what is seen at x for a key of p, stays the same where
        // x moves by -(dn/dx)^-1 dn/dp. Nothing: what falls into the hole, and where the picture is folded (dn/dx has no inverse).
        struct Move {
            double right, down;
        };
        std::optional<Move> move;
        Vec3 sky{0, 0, 0};  // of the direction on the sky; 0 where light comes from none
        double shift = 0;   // of the frequency in the camera over that at infinity
        double delay = 0;   // of T, r_s/c; likewise
    };
    struct Place {
        bool sees_sky;        // behind the disc, too
        double off_critical;  // px to the critical curve, by the first derivative; infinite where there is none
        std::vector<ByKey> by;
    };
    // x, y: px from the picture's upper left corner. Error: that of ray_gradient(). Half a millisecond for all keys.
    Place at(double x, double y) const;

private:
    PictureMotion() = default;
    Scene scene_;
    std::vector<Parameter> keys_;
    std::unique_ptr<Flow> flow_;
    std::optional<CameraView> view_;
};

}  // namespace nullscope
