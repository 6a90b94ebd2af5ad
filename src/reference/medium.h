// Matter along rays for the reference: where a ray is looked at, and what matter there emits and absorbs. Frequencies by the metric's own
// components and their inverse, ways by |x|^2 ds (kerr_flow.h) or r^2 dphi/L.
#pragma once
#include <memory>
#include <vector>

#include "reference/emission.h"
#include "reference/matter_model.h"
#include "reference/metric.h"
#include "scene/scene.h"

namespace nullscope::reference {

class Medium {
public:
    // Of a scene that has one. matter: outlives this.
    Medium(const Scene& scene, const Metric& matter);
    using Place = MatterPlace;
    using Slopes = MatterPlace::Slopes;
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
    double farthest() const { return model_->farthest(); }
    double nearest() const { return nearest_; }

    // Along one node. energy, momentum: of a photon of unit frequency in the camera; r_s.
    using Light = MatterLight;
    Light at(const MediumNode& node, double energy, double momentum) const;

private:
    struct Look {
        double along;
        Place place;
        double panel;  // how long one may be there
    };
    Look look(double along, const Way& way) const;
    void split(const Look& begin, const Look& end, int depth, const Way& way, std::vector<MediumNode>& nodes) const;
    const Metric& matter_;
    std::unique_ptr<const MatterModel> model_;
    Emission law_;
    bool moves_, by_direction_;  // it asks for its nodes' slopes
    double nearest_;
};

}  // namespace nullscope::reference
