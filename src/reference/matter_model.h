// The models of matter along rays, for the reference: a class a model (matter_models.cpp, matter_gas.cpp) says where it is to be looked at,
// and what is there. Rays and sums are medium.h's, light is that of emission.h.
#pragma once
#include <cmath>
#include <memory>
#include <optional>

#include "base/result.h"
#include "base/vec.h"
#include "plan/medium.h"
#include "reference/emission.h"
#include "reference/metric.h"
#include "scene/scene.h"

namespace nullscope::reference {

// A part of a ray, as matter asks for it.
struct MatterPlace {
    struct Slopes {
        double r, theta;  // by the affine parameter of a photon of unit frequency in the camera
    };
    double r;                        // Boyer and Lindquist's
    Vec3 direction;                  // of its angles: unit, world axes
    double delay = 0;                // how long ago the light left, where the medium moves
    std::optional<Slopes> slopes{};  // where they are known without differences
    Vec3 flat() const { return r * direction; }
    double off_axis() const { return r * std::sqrt(direction.x * direction.x + direction.y * direction.y); }
};

class MatterModel {
public:
    MatterModel(const Scene& scene, const Metric& metric)
        : metric_(metric),
          spec_(*scene.medium),
          time_(scene.time),
          farthest_(medium_farthest(spec_)),
          horizon_(metric.horizon_radius().value_or(0.0)) {}
    virtual ~MatterModel() = default;
    // How far panels of a midpoint rule may be from node to node here, r_s.
    virtual double panel(const MatterPlace& place) const = 0;
    // nothing: there is none. g: of the metric there.
    virtual std::optional<MatterState> at(const MediumNode& node, const PlaceMetric& g) const = 0;
    // It is the same at every azimuth, of which light has many next to a rotating horizon.
    virtual bool all_round() const { return true; }
    // It moves in circles about the axis: the light's direction in the meridian's plane does not change its frequency.
    virtual bool goes_round() const { return false; }
    // Ends of panels have azimuths this much apart at most, r_s; 0: it is the same all round, or tells by panel().
    virtual double turn() const { return 0; }
    double horizon() const { return horizon_; }
    double farthest() const { return farthest_; }

protected:
    double time_of(const MediumNode& node) const { return time_ - node.delay; }
    const Metric& metric_;
    MediumSpec spec_;
    double time_, farthest_, horizon_;
};

inline constexpr double kMatterPanel = 0.08;  // of the length over which matter changes: 1e-4 of the flux

// What a model reads, which make_matter() then has. Errors: of files.
Status read_matter(const Spacetime& spacetime, const Scene& scene);
// By the scene's medium.kind. metric: outlives it.
std::unique_ptr<MatterModel> make_matter(const Scene& scene, const Metric& metric);
std::unique_ptr<MatterModel> make_gas(const Scene& scene, const Metric& metric);

// Four-velocity along e_phi of the observer of no angular momentum, of matter with u = u^t (1, 0, 0, rate); and with u_phi = -l u_t.
Vec3 velocity_at_rate(const PlaceMetric& g, double rate);
Vec3 velocity_with_momentum(const PlaceMetric& g, double l);

}  // namespace nullscope::reference
