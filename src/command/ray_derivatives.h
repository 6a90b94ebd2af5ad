// Derivatives of what a list of rays gives, what nullscope trace --derivatives does (docs/ray-data.md, "Derivatives").
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "gradient/disc_motion.h"
#include "gradient/parameter.h"
#include "gradient/ray_gradient.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

// kEdge: within a tenth of a pixel of the scene's camera from the critical curve or, at a crossing, from a rim of the disc: they hold for less
// than that; or a crossing is within 1e-5 of the horizon, of which there are none. kLost: there are none, since the ray is not found again to 1e-7.
enum class DerivativeState { kThere, kEdge, kLost };
inline constexpr const char* kDerivativeStates[] = {"yes", "edge", "lost"};

// Of one ray; not a number where the ray has no such value.
struct RayDerivatives {
    DerivativeState state = DerivativeState::kLost;
    std::vector<double> values;  // parameter after parameter, in the order of derivative_columns()
};

class DerivativeTracer {
public:
    // Errors: a metric without derivatives; parse_parameters'.
    static Result<DerivativeTracer> make(const Scene& scene, const std::vector<std::string>& parameters, int crossings);

    // d_NAME.x, .y, .z of the direction on the sky, .g, .delay, and of each crossing .r_k, .phi_k, of a thermal disc .g_k
    std::vector<std::string> columns() const;
    // record: that of the reference. Errors: a ray of another form than the general one, of an observer that falls. Half a millisecond.
    Result<RayDerivatives> derivatives(const RayQuery& ray, const RayRecord& record) const;

private:
    DerivativeTracer() = default;
    DerivativeState state_of(const RayGradient& found, const RayRecord& record) const;
    Scene scene_;
    std::vector<Parameter> parameters_;
    std::shared_ptr<const Flow> flow_;
    std::shared_ptr<const DiscMotion> motion_;  // of a disc whose matter has a g
    int crossings_ = 0;
};

}  // namespace nullscope::cli
