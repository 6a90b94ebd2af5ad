// What emits a line: a disc, or one ring of it, as a scene and options of `nullscope spectrum` say.
#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "scene/disc_emissivity.h"
#include "scene/scene.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spacetime.h"
#include "spectrum/line_profile.h"

namespace nullscope::cli {

inline constexpr double kFarthestRim = 1e6;  // r_s
inline constexpr double kOneDegree = M_PI / 180.0;

struct LineOptions {
    std::string scene, inner, emissivity, limb = "isotropic";
    std::optional<double> spin, inclination_deg, outer, ring;
};

// What is seen, from the scene and the options.
struct LineSource {
    std::string name;  // the scene's, and the metric with its parameters
    std::shared_ptr<const Spacetime> spacetime;
    double inclination = 0, inner = 0, outer = 0, isco = 0;
    Sense sense = Sense::kEastward;
    EmissivitySpec emissivity{};
    bool thermal() const { return emissivity.by == Emissivity::kAccretion; }
    Scene scene{};
    bool from_below() const { return inclination_deg > 90.0; }
    double inclination_deg = 0;  // as it was asked for, of either face
};

// Errors (bad input): the options' and the disc's; no innermost stable orbit.
Result<LineSource> line_source(const LineOptions& options);  // of its scene, or a hole of its spin
Result<LineSource> line_source(const LineOptions& options,
                               Scene scene);  // options.scene: only whether there is one
// source outlives it.
DiscLine disc_line(const LineSource& source, const LineOptions& options);

}  // namespace nullscope::cli
