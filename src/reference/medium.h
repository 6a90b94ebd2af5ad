// Matter along rays for the reference: where a ray is looked at, and what matter there emits and absorbs. Frequencies by the metric's own
// components and their inverse, ways by the tracer's affine parameter or r^2 dphi/L.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "expr/formula.h"
#include "reference/emission.h"
#include "reference/metric.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"

namespace nullscope::reference {

class Medium {
public:
    // Of a scene that has one. matter: outlives this.
    Medium(const Scene& scene, const Metric& matter);
    // Nodes of midpoint rules, in order, of a part of a ray between two values of `along`, with places at both ends; `at` gives others.
    // way(node, width): of the affine parameter of a photon of unit frequency in the camera, for a width in `along`.
    struct Place {
        double r, theta, phi = 0,
                         delay = 0;  // Boyer and Lindquist's; how long ago the light left, where the medium moves
    };
    using At = std::function<Place(double along)>;
    void add_nodes(double from, double to, const At& at, const std::function<double(const Place&, double)>& way,
                   std::vector<MediumNode>& nodes) const;
    bool moves() const { return moves_; }
    double farthest() const { return farthest_; }
    double nearest() const { return nearest_; }

    // Along one node. energy, momentum: of a photon of unit frequency in the camera; r_s.
    using Light = MatterLight;
    Light at(const MediumNode& node, double energy, double momentum) const;

private:
    Light gas(const MediumNode& node, double energy, double momentum) const;
    Light flow(const MediumNode& node, double energy, double momentum) const;
    Light by_place(const MediumNode& node, double energy, double momentum) const;
    MatterState formula(const MediumNode& node) const;
    double panel(const Place& place) const;
    void split(double from, const Place& begin, double to, const Place& end, int depth, const At& at,
               const std::function<double(const Place&, double)>& way, std::vector<MediumNode>& nodes) const;
    struct Formulas {
        expr::Formula density, temperature, field, outward, south, east;
    };
    const Metric& matter_;
    std::optional<Formulas> formulas_;        // of kFormula
    std::shared_ptr<const MediumGrid> grid_;  // of kGrid
    std::optional<Emission> emission_law_;
    bool moves_ = false;
    MediumSpec spec_;
    LightSpec light_;
    std::function<double(double r)> rate_;  // of kGas: Omega of circular orbits
    double unit_light_ = 1;
    double time_, farthest_, nearest_, horizon_;
    double emission_ = 0, absorption_ = 0;  // for each r_s, of unit density without shift
};

}  // namespace nullscope::reference
