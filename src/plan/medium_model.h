// The models of matter along rays: what the host says of each in one row, a file a model (medium_gas.cpp, medium_flow.cpp,
// medium_formula.cpp, medium_file.cpp, medium_jet.cpp); CONTRIBUTING.md has the recipe. What of it runs on the GPU is shaders/medium/WORD.glsl.
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "plan/effects.h"
#include "plan/frame_plan.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "scene/scene_key.h"

namespace nullscope {

// What several models have: bits of MediumModel::shares. Of MediumSpec's members with these names; kSphere: height and steps, its sphere is
// of radius `outer`; kLaws: it shines by `emission`; kWarmth: its temperature and field are formulas of the scene.
enum MediumShare : unsigned {
    kInner = 1,
    kOuter = 2,
    kEdge = 4,
    kSphere = 8,
    kDensityScale = 16,
    kLaws = 32,
    kWarmth = 64
};

// How the march takes it (shaders/medium/march.glsl).
struct MediumTraits {
    bool own_steps = false;  // samples as long as it says where they begin; else four to a span
    bool azimuth = false;    // it depends on the azimuth, and ends before the horizon
    bool turn = false;       // it depends on the azimuth, which about a rotating hole is told apart (MediumPlace::turn)
    bool any_density = false;  // densities have any size, and logarithms are taken; else a power law's are 1 at most
};

// What its numbers are made of. grid: of a file, else nullptr.
struct MediumFrame {
    const FramePlan& plan;
    const MediumGrid* grid;
    const MediumSpec& medium() const { return *plan.scene.medium; }
};

struct MediumModel {
    std::string_view word;  // of medium.kind
    std::string_view what;  // for the help of medium.kind
    EffectRow effect;
    unsigned shares;
    MediumTraits traits;
    std::vector<SceneKey> (*keys)();          // its own
    std::string (*words)(const MediumSpec&);  // of a plan: "density exp(-r)"
    double (*farthest)(const MediumSpec&);    // radius beyond which there is none, r_s
    double (*least_step)(const MediumSpec&);  // of the march, r_s; nullptr: kLeastStep of that radius
    double (*spans)(const MediumSpec&,
                    double horizon);  // of four samples at most that a ray takes, at medium.step 1; nullptr: few
    const char* (*moves)(const MediumSpec&);  // the key by which it changes with time; nullptr: it does not
    void (*faults)(const Spacetime&, const Scene&, std::vector<SceneFault>&);  // nullptr: none
    std::string_view numbers;  // that its file knows by these names, 24 at most, and their values
    std::vector<double> (*values)(const MediumFrame&);
    void (*before)(Scene&), (*with)(Scene&);  // Feature's
    double (*opacity)(const MediumSpec&) =
        nullptr;  // of a black body, for each r_s where the density is 1; nullptr: the key's
};
inline constexpr double kLeastStep = 1e-6;
inline constexpr double kTurned = 2.0 * M_PI;  // rays that wind further about a hole are thinner than a pixel
double spans_to_horizon();                     // of samples that shorten before it (shaders/medium/place.glsl)

extern const MediumModel kGasModel, kFlowModel, kFormulaModel, kFileModel, kJetModel;
inline std::array<const MediumModel*, kMediumKinds> medium_models() {  // by MediumKind
    return {&kGasModel, &kFlowModel, &kFormulaModel, &kFileModel, &kJetModel};
}
inline const MediumModel& model_of(const MediumSpec& medium) {
    return *medium_models()[static_cast<std::size_t>(medium.kind)];
}
const MediumModel* model_of(const EffectSet& effects);  // nullptr: no medium

// Keys of several models: whether the scene's has a share, and what to say else: kind = "gas" or "jet".
inline bool has_share(const Scene& scene, unsigned share) { return (model_of(*scene.medium).shares & share) != 0; }
template <unsigned share>
bool shared(const Scene& scene) {
    return has_share(scene, share);
}
std::string_view kinds_with(unsigned share);

// Parts of examples.
inline void massive_hole(Scene& s) {
    s.spacetime.metric = "schwarzschild";
    s.object.mass_suns = 4.3e6;
}

// Of matter within a sphere and a slab: radius, |z|, length of a sample.
inline constexpr std::string_view kSphereNumbers = "SPHERE_RADIUS SPHERE_HEIGHT SPHERE_STEP";
inline std::vector<double> sphere_values(const MediumFrame& f) {
    const MediumSpec& m = f.medium();
    return {m.outer, m.height, 2.0 * m.outer / m.steps};
}
inline double sphere_spans(const MediumSpec& m, double horizon) {
    const double across =
        1.0 + kTurned * horizon / m.outer;  // a chord, and round the hole at twice the horizon's radius
    return 0.25 * m.steps * across + (horizon > 0.0 ? spans_to_horizon() : 0.0);
}

// Keys by which matter changes with time: whether a formula asks for t, and that of kWarmth.
bool asks_for_time(const std::string& formula);
const char* warmth_moves(const MediumSpec& medium);

// What all laws are told, by these names; then four of kPowerLaw, or of electrons that are not thermal. light: factor on medium.colour.
inline constexpr std::string_view kLawNumbers =
                                      "LAW_SHIFT LAW_BEAMING LAW_FREQUENCY LAW_OPACITY LAW_UNIT LAW_BLACK LAW_BRIGHT "
                                      "LAW_TIME ",
                                  kPowerLawNumbers = "LAW_EMITTED_POWER LAW_ABSORBED_POWER LAW_ABSORBED LAW_EMITTED",
                                  kElectronNumbers = "ELECTRON_FIRST ELECTRON_RATE ELECTRON_KAPPA";
inline constexpr std::size_t kLawValues = 12;  // with the larger of the last two
// What each of several frequencies has of its own, by these names.
inline constexpr std::string_view kBandNumbers = "LAW_FREQUENCY LAW_UNIT LAW_ABSORBED LAW_EMITTED";
struct LawNumbers {
    std::vector<double> values;
    double light;
    std::vector<std::array<double, 4>> bands{};  // of kMediumBands, red first
};
LawNumbers law_numbers(const FramePlan& plan);

}  // namespace nullscope
