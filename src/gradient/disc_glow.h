// The light of a thermal disc where rays cross it, in dual numbers: what leaves its matter (accretion's flux, a power law or a table; rims, pattern), its redshift
// and the colour of a black body, by the laws of docs/light.md. Shares no code with the shader nor with the reference but formulas' parser and tables of
// the standard observer.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "expr/formula.h"
#include "gradient/disc_motion.h"
#include "gradient/parameter.h"
#include "scene/disc_emissivity.h"
#include "scene/scene.h"

namespace nullscope {

// Linear Rec. 709 as pictures have it.
using Colour = std::array<Shade, 3>;

// A radius where the light's law changes: rims, ends of soft rims, the last stable circle, breaks.
using LightMark = Shade;

class DiscGlow {
public:
    // flow: of the scene's spacetime; outlives this. A turbulent gas counts as its mean. Some 30 milliseconds. Errors: what has no derivatives here: emission
    // = image, textures but plain, gas and formula, lamps, limb darkening, warps, spots, bodies, matter along rays, discs without a horizon that accrete; a
    // table that cannot be read.
    static Result<std::unique_ptr<DiscGlow>> make(const Scene& scene, const Flow& flow);

    struct Light {
        Colour colour;   // of what the disc adds, coverage included
        Shade coverage;  // what it takes of what is behind
        Shade g;         // frequency in the camera over that in the matter
    };
    // shift: frequency in the camera over that of who has no angular momentum there.
    Light at(const Photon& photon, const RayGradient::Crossing& crossing, const Number& shift) const;
    double emissivity(double r) const { return heat(Number(r)).value; }  // over the largest
    bool within(double r) const { return r >= spec_.inner && r <= spec_.outer; }
    const DiscMotion& motion() const { return motion_; }
    std::vector<LightMark> marks() const;  // ascending, within the rims

private:
    DiscGlow(const Scene& scene, const Flow& flow, double sense);
    Status prepare();
    Shade heat(const Number& r) const;
    struct LawChange {
        double r, power;  // r_s; by how much the emissivity's power of r changes there
    };
    std::vector<LawChange> law_changes() const;  // within the rims; none of accretion
    Shade law(const Shade& r) const;
    Shade power_law(const Shade& r) const;
    Shade between_rows(const Shade& r) const;
    Shade within_rims(const Shade& r) const;
    Colour pattern(const Shade& r, const Shade& azimuth) const;
    Colour black_body(const Shade& temperature, const Shade& g) const;
    Shade brightness(const Shade& temperature) const;

    DiscSpec spec_;
    LightSpec light_;
    const Flow& flow_;
    DiscMotion motion_;
    std::optional<AccretionHeat> accretion_;
    std::shared_ptr<const std::vector<EmissivityRow>> rows_;
    std::optional<expr::Formula> formula_;
    Shade temperature_, most_{1.0},
        unit_{1.0};  // of the hottest ring, K; the largest emissivity; brightness of that ring
};

Shade lifted(const Number& number);
// Of the scene's disc about this hole: 1 towards growing phi, -1 towards falling phi.
double sense_of(OrbitSense sense, const Flow& flow);

}  // namespace nullscope
