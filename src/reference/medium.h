// Matter along rays for the reference: where a ray is looked at, and what matter there emits and absorbs. Frequencies by the metric's own
// components and their inverse, ways by |x|^2 ds (kerr_flow.h) or r^2 dphi/L.
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
    struct Slopes {
        double r, theta;  // by the affine parameter of a photon of unit frequency in the camera
    };
    // A part of a ray, as matter asks for it.
    struct Place {
        double r;                        // Boyer and Lindquist's
        Vec3 direction;                  // of its angles: unit, world axes
        double delay = 0;                // how long ago the light left, where the medium moves
        std::optional<Slopes> slopes{};  // where they are known without differences
        Vec3 flat() const { return r * direction; }
    };
    class Way {
    public:
        virtual ~Way() = default;
        virtual Place at(double along) const = 0;
        // Of that parameter, for a width in `along`.
        virtual double affine(const Place& place, double width) const = 0;
    };
    // Nodes of midpoint rules, in order, between two values of `along`.
    void add_nodes(double from, double to, const Way& way, std::vector<MediumNode>& nodes) const;
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
    struct Look {
        double along;
        Place place;
        double panel;  // how long one may be there
    };
    Look look(double along, const Way& way) const;
    void split(const Look& begin, const Look& end, int depth, const Way& way, std::vector<MediumNode>& nodes) const;
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
