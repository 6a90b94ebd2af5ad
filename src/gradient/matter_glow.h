// What a scene's matter emits and absorbs where a ray is, in dual numbers (docs/matter.md): flows and matter by formulas, that shine by a power of
// the frequency, as thermal electrons in a field or among protons. Shares no code with the shader nor with the reference but formulas' parser and the
// bounds of plan/medium.h.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "expr/formula.h"
#include "gradient/flow.h"
#include "scene/scene.h"

namespace nullscope {

// Seeds of a disc's leaning, which matter does not have.
inline constexpr Seed kSeedMatterTurn = kSeedNode;  // of the matter about the polar axis
inline constexpr Seed kSeedMatterShift =
    kSeedTilt;  // ln of the camera's frequency, of what does not come by way of the ray

class MatterGlow {
public:
    // flow: of the scene's spacetime, with a horizon; outlives this. Errors: another medium.kind than flow and formula, black bodies, electrons that are not thermal,
    // polarised light, several frequencies, a height within the sphere, formulas with t or noise, a disc, bodies.
    static Result<std::unique_ptr<MatterGlow>> make(const Scene& scene, const Flow& flow);

    // For each unit of Mino's time, r_s: light without what the matter before it takes, where 1 is the brightness temperature kMediumLight_K; optical depth.
    struct Rates {
        Number light, depth;
    };
    // shift: frequency in the camera over that of who has no angular momentum there. Some 3 microseconds.
    Rates at(const Photon& photon, const RayState& state, const Number& shift) const;

    double nearest() const { return nearest_; }          // r_s; none within and beyond these
    double farthest() const { return farthest_; }        // it may end sharply there
    double scale(double r) const { return scale_ * r; }  // over which it changes, about

private:
    MatterGlow(const Scene& scene, const Flow& flow);
    Status prepare();
    struct Place;
    struct Matter {
        Number density, temperature, field;
        Triple velocity;  // four-velocity's along e_r, e_theta, e_phi of who has no angular momentum
    };
    struct Seen {
        Number frequency, sine;  // of a photon of frequency 1 for who launched it; of its angle to the field
    };
    std::optional<Matter> matter(const Place& place) const;
    std::optional<Triple> velocity(const Place& place) const;
    Number formula(const expr::Formula& formula, const Place& place) const;
    Seen seen(const Photon& photon, const RayState& state, const Place& place, const Triple& velocity) const;
    Rates coefficients(const Matter& matter, const Number& nu, const Number& sine) const;

    MediumSpec spec_;
    LightSpec light_;
    const Flow& flow_;
    double length_cm_, unit_, nearest_, farthest_, scale_ = 1;  // unit: of light 1, cgs
    std::vector<expr::Formula> formulas_;  // temperature, field; of kFormula density and velocity too
};

}  // namespace nullscope
