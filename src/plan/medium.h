// Matter along rays: where it may be, and what its numbers are in the units of light and r_s.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "light/electron_energies.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

class Spacetime;

// Where a metric has A = Delta/r^2 or is of Kerr's form: what matter that goes round needs of it. r_s.
struct MediumHole {
    double a, outer, inner;
};
std::optional<MediumHole> medium_hole(const Spacetime& spacetime);

// Of a scene with a medium: metrics, views and parts of light in which it is not followed, a missing mass.
std::vector<SceneFault> medium_faults(const Spacetime& spacetime, const Scene& scene);
Status check_medium(const Spacetime& spacetime, const Scene& scene);  // the first of them

// Spans of four samples that a ray's march takes at most.
double medium_spans(const Spacetime& spacetime, const MediumSpec& medium);

// Of a medium that is a file's grid: what the file says of its hole and the scene's spacetime does not have, a line for people. Empty: nothing.
std::string medium_note(const Spacetime& spacetime, const Scene& scene);

// What formulas of matter may ask for: x, y, z, r (r_s), t (r_s/c).
const std::vector<std::string>& medium_variables();

// The key by which matter changes with time; nullptr: it does not.
const char* medium_moves(const MediumSpec& medium);

// Of a power law: Light of the densest matter for each r_s where g = 1, and its optical depth.
struct FlowNumbers {
    double emission, absorption;
};
FlowNumbers flow_numbers(const MediumSpec& medium, double mass_suns);

// Limits of matter by formula, of the shader (shaderlib/medium_text.h) and of the reference. The formulas of synchrotron radiation are of
// relativistic electrons: colder ones have none. Each component of gamma v, c.
inline constexpr double kColdest_K = 5e8, kFastestMatter = MediumGrid::kFastest;

// Of a medium that has_electrons().
ElectronEnergies electron_energies(const MediumSpec& medium);

// Of light 1 at a frequency: erg/(s cm^2 Hz sr), of the brightness temperature kMediumLight_K (Rayleigh and Jeans).
double medium_light_cgs(double frequency_ghz);

// Beyond and within these there is none, r_s. The inner one is 5e-5 r_s above the horizon.
inline constexpr double kMediumAboveHorizon = 5e-5;
inline constexpr double kFlowScales = 6.0;  // of density: exp(-18) of the densest
inline constexpr double kGasHeights = 3.5;  // scale heights: exp(-6)
double medium_farthest(const MediumSpec& medium);

}  // namespace nullscope
