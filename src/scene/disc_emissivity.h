// The emissivity of a thermal disc that is not powered by accretion: power laws with breaks, a table, a lamp on its axis.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {

// Between two rows it is a power of the radius; before the first and after the last nothing shines.
struct EmissivityRow {
    double r, value;  // r_s, any unit
};
inline constexpr std::size_t kMostEmissivityRows = 100'000;

// A table: lines "r, epsilon", with a header line or not, # begins a comment. Errors, with the line: fewer than two numbers, radii that do not grow, what
// is not finite or not positive (radii from 1e-6 to 1e6, values from 1e-200 to 1e200), fewer than two rows or too many.
Result<std::vector<EmissivityRow>> read_emissivity(std::string_view text);
// The file's, kept for as long as it does not change.
Result<std::shared_ptr<const std::vector<EmissivityRow>>> load_emissivity(const std::filesystem::path& file);

// At each of these radii (r_s, outside the horizon, any order), in any unit; finite, >= 0. spec.by: not kAccretion. A table that cannot be read shines
// nowhere. Cost of a lamp: spacetime/lamp_light.h.
std::vector<double> disc_emissivity(const Spacetime& spacetime, const std::vector<double>& radii,
                                    const EmissivitySpec& spec, Sense sense);

// The same over the largest value between the first and the last of these radii, the rims of the disc, breaks and rows of a table included: at most 1. Dark
// everywhere: 0.
std::vector<double> disc_emissivity_shares(const Spacetime& spacetime, const std::vector<double>& radii,
                                           const EmissivitySpec& spec, Sense sense);

// "r^-3", "r^-7 to 3 r_s, r^-3", "a lamp at 5 r_s", "table fe.csv"
std::string emissivity_words(const EmissivitySpec& spec);

}  // namespace nullscope
