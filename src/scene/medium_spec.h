// Matter that emits and absorbs light along rays (docs/matter.md): a model says what it is, an emission law, chosen by itself, how it
// shines. A model is added by a kind and a struct here, its row (plan/medium_model.h), its file in shaders/medium and its class in
// reference/matter_models.cpp; a law by a row of kEmissionLaws, its file and its formula in reference/emission.cpp. Lengths in r_s.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace nullscope {

// Motion of a pattern: none, or every ring at the angular velocity of circular geodesics (docs/time.md).
enum class DiscFlowKind { kStill, kKepler };

// Which way what circles goes: towards growing phi, towards falling phi, or with and against the rotation of the hole, without which prograde
// is eastward (scene/orbit_sense.h).
enum class OrbitSense { kEastward, kWestward, kPrograde, kRetrograde };

// Turbulent gas, of a disc or a medium: what its light or density is multiplied by, of mean 1 at every radius (docs/light.md). With
// DiscFlowKind::kKepler it moves.
struct GasSpec {
    double contrast = 0.7;  // [0, 1]; 0: smooth
    double winding = 4.0;   // rad by which filaments trail for each unit of ln r, [0, 30]
    friend bool operator==(const GasSpec&, const GasSpec&) = default;
};

enum class MediumKind { kGas, kFlow, kFormula, kGrid, kJet, kEnd };
inline constexpr auto kMediumKinds = static_cast<std::size_t>(MediumKind::kEnd);

// A soft disc of gas in circular orbits from inner to outer, Gaussian across the plane; temperature (r/inner)^(-3/4).
struct GasMatter {
    double thickness = 0.1;      // scale height over the radius
    double optical_depth = 4.0;  // along the normal
    GasSpec clumps{};            // of its density, with the same words as a disc's
    DiscFlowKind flow = DiscFlowKind::kStill;
    OrbitSense sense = OrbitSense::kEastward;
    friend bool operator==(const GasMatter&, const GasMatter&) = default;
};
// A hot flow about the hole (Gold et al. 2020): density exp(-((r/radius)^2 + (flattening cos theta)^2)/2), angular momentum per energy
// momentum R^1.5/(1 + R), R = r sin theta in M.
struct FlowMatter {
    double radius = 5.0, flattening = 0.0, momentum = 1.0;
    friend bool operator==(const FlowMatter&, const FlowMatter&) = default;
};
// Formulas (docs/expressions.md) of x, y, z, r in r_s and of t in r_s/c. Temperature and field are those of every model without its own.
struct MediumFormulas {
    std::string density =
        "exp(-r^2/18)";               // of kPowerLaw and kBlackBody: over that of emissivity, opacity; electrons a cm^3
    std::string temperature = "1e4";  // K; of kSynchrotron: of the electrons
    std::string field = "10";         // kSynchrotron: magnetic field, G
    // Four-velocity along (e_r, e_theta, e_phi) of the observer of no angular momentum at the place: gamma v, c.
    std::string outward = "0", south = "0", east = "0";
    friend bool operator==(const MediumFormulas&, const MediumFormulas&) = default;
};
// scene/medium_grid.h; of a simulation's dumps, which a placeholder in the file's name stands for (scene/medium_dumps.h), the numbers of the
// first and the last one (below 0: those of the folder, once the scene was read), the time between two and that of the first; r_s/c.
// kSlow: each place is seen at its own time, when its light left; kFast: all of a picture at the scene's time.
enum class DumpLight { kFast, kSlow };
struct GridMatter {
    std::filesystem::path file{};
    int first = -1, last = -1;
    double cadence = 0.0, start = 0.0;
    DumpLight light = DumpLight::kFast;
    friend bool operator==(const GridMatter&, const GridMatter&) = default;
};

// Two cones about the spin axis, from r = inner to outer: density (r/inner)^-falloff, across a cone (1 - (sin theta/sin opening)^2)^2, and
// rims at both ends. It flows out along the radius.
struct JetMatter {
    double opening = 0.17453292519943295;  // half the cone's angle
    double falloff = 2.0;
    double lorentz = 3.0;  // of the observer of no angular momentum
    friend bool operator==(const JetMatter&, const JetMatter&) = default;
};

// Energies of the electrons of kSynchrotron, gamma of each: a thermal distribution of local_temperature T; gamma^-index from gamma_min to gamma_max;
// gamma sqrt(gamma^2 - 1) (1 + (gamma - 1)/(kappa w))^-(kappa + 1) with w = k T/(m c^2), which is thermal where kappa is large.
enum class ElectronKind { kThermal, kPowerLaw, kKappa };
struct ElectronSpec {
    ElectronKind kind = ElectronKind::kThermal;
    double index = 3.0, gamma_min = 30.0, gamma_max = 1e5;
    double kappa = 3.5;
    friend bool operator==(const ElectronSpec&, const ElectronSpec&) = default;
};

enum class MediumEmission { kPowerLaw, kBlackBody, kSynchrotron, kBremsstrahlung };  // by kEmissionLaws
struct EmissionLaw {
    std::string_view word;    // of the key; its file is shaders/medium/WORD.glsl, with _ in place of -
    std::string_view what;    // for the key's help
    bool by_frequency;        // seen at one frequency, in brightness temperatures
    bool temperature, field;  // asks for these
};
inline constexpr EmissionLaw kEmissionLaws[] = {
    {"power-law", "a power of the frequency", true, false, false},
    {"black-body", "Planck's law at its temperature, with the same opacity at all frequencies", false, true, false},
    {"synchrotron", "electrons in a magnetic field", true, true, true},
    {"bremsstrahlung", "thermal electrons among protons", true, true, false},
};

// Of the magnetic field in the frame of the matter; kIsotropic: the mean over all directions; kFile: the file's, of kGrid alone; kVector: MediumSpec::field_vector.
enum class FieldDirection { kIsotropic, kOutward, kSouth, kEast, kFile, kVector };

struct MediumSpec {
    MediumKind kind = MediumKind::kGas;
    GasMatter gas{};
    FlowMatter flow{};
    MediumFormulas formulas{};
    GridMatter grid{};
    JetMatter jet{};
    // What several models have (MediumModel::shares): radii between which matter is, the width of both rims in ln r; |z| < height; samples
    // across the sphere of radius `outer`; a factor on densities, and the root of it on a file's field.
    double inner = 3.0, outer = 12.0, edge = 0.25, height = 1e6;
    int steps = 64;
    double density_scale = 1.0;

    MediumEmission emission = MediumEmission::kPowerLaw;  // where the model has a choice: law()
    // kPowerLaw: emissivity and absorptivity at 230 GHz in the matter's frame, where the density is 1; nu^-spectral_index and
    // nu^-(2.5 + spectral_index) times that.
    double spectral_index = 0.0;
    double emissivity = 3e-18;     // erg/(s cm^3 Hz sr)
    double absorption = 0.0;       // absorptivity over emissivity
    double frequency_GHz = 230.0;  // at which the camera looks; of several the one that is shown (scene/medium_bands.h)
    std::vector<double> bands_GHz{};  // several, ascending; empty: one
    int shown_band = 0;  // of several: which one pictures show, from 1; 0: all as colours, of polarised light the first
    double temperature_K = 8000.0;  // of gas at its inner radius; else of the black body of light 1
    double opacity = 1.0;           // kBlackBody: optical depth for each r_s where the density is 1
    FieldDirection field_direction = FieldDirection::kIsotropic;  // kSynchrotron
    ElectronSpec electrons{};                                     // kSynchrotron
    Vec3 field_vector{0, 0, 1};  // kVector: radial, azimuthal and north component, of any length above 0
    bool polarisation = false;   // of kSynchrotron in a field of one direction: I, Q, U, V are transferred ...
    bool faraday = true;         // ... with Faraday's rotation and conversion

    // Linear light; 1 is a brightness temperature of kMediumLight_K where by_frequency(), else a black body of temperature_K.
    Vec3 colour{1, 1, 1};
    double brightness = 1.0;
    double step = 1.0;  // of the march, over the usual one (docs/matter.md says how exact that is)

    MediumEmission law() const { return kind == MediumKind::kGas ? MediumEmission::kBlackBody : emission; }
    const EmissionLaw& law_row() const { return kEmissionLaws[static_cast<std::size_t>(law())]; }
    bool by_frequency() const { return law_row().by_frequency; }
    // Of kSynchrotron whose electrons are not thermal; whether its light depends on a temperature; on that or on a field.
    bool has_electrons() const {
        return law() == MediumEmission::kSynchrotron && electrons.kind != ElectronKind::kThermal;
    }
    bool warm() const {
        return law_row().temperature && !(has_electrons() && electrons.kind == ElectronKind::kPowerLaw);
    }
    bool by_place() const { return warm() || law_row().field; }
    friend bool operator==(const MediumSpec&, const MediumSpec&) = default;
};
inline constexpr double kMediumLight_K = 1e9;
// Along e_r, e_theta, e_phi, unit; 0 of kIsotropic and kFile.
inline Vec3 field_way_of(const MediumSpec& medium) {
    switch (medium.field_direction) {
        case FieldDirection::kOutward: return {1, 0, 0};
        case FieldDirection::kSouth: return {0, 1, 0};
        case FieldDirection::kEast: return {0, 0, 1};
        case FieldDirection::kVector: {
            const Vec3 v = normalized(medium.field_vector);
            return {v.x, -v.z, v.y};
        }
        case FieldDirection::kIsotropic:
        case FieldDirection::kFile: break;
    }
    return {0, 0, 0};
}
inline bool can_be_polarised(const MediumSpec& medium) {
    return medium.law() == MediumEmission::kSynchrotron && medium.field_direction != FieldDirection::kIsotropic;
}
inline bool is_polarised(const MediumSpec& medium) { return medium.polarisation && can_be_polarised(medium); }

}  // namespace nullscope
