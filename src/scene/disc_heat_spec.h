// What a thermal disc shines by, and what changes its light, as scenes give it.
#pragma once
#include <filesystem>
#include <vector>

#include "base/vec.h"
#include "spacetime/lamp_light.h"

namespace nullscope {

// What heats a thermal disc. Rates in L_Eddington/(0.1 c^2), L_Eddington = 4 pi G M m_p c/sigma_T.
struct AccretionSpec {
    double mass_suns = 1e8, rate_eddington = 0.1;
    friend bool operator==(const AccretionSpec&, const AccretionSpec&) = default;
};

// Effects on a disc's light that are on or off, each with a key (scenefile/scene_keys.h, on_off_key).
struct DiscEffects {
    bool limb_darkening = false;  // thermal: Chandrasekhar's law for an electron-scattering atmosphere
    friend bool operator==(const DiscEffects&, const DiscEffects&) = default;
};

// Its emissivity: the power per area in the frame of the matter, by radius, in any unit. kAccretion: Page and Thorne's flux (table/disc_light.h).
// kPowerLaw: r^-q, continuous, q the component of `powers` that `breaks` choose. kTable: of a file's rows (scene/disc_emissivity.h). kLamp: what a
// lamp on the disc's axis sends there.
enum class Emissivity { kAccretion, kPowerLaw, kTable, kLamp };
struct EmissivitySpec {
    Emissivity by = Emissivity::kAccretion;
    Vec3 powers{
        3, 3,
        3};  // q within the first break, up to the second, beyond it; with one break the first two, without the first
    std::vector<double> breaks{};  // r_s, ascending, two at most
    std::filesystem::path file{};  // kTable
    LampPost lamp{};
    friend bool operator==(const EmissivitySpec&, const EmissivitySpec&) = default;
};
inline constexpr std::size_t kMostBreaks = 2;

}  // namespace nullscope
