// How the panels write lengths, times and other numbers: units of lengths and times, and the decimal sign.
#pragma once
#include <string>

#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::viewer {

// kOwn: of wormholes, which have no r_s; it cannot be chosen.
enum class LengthUnit { kSchwarzschildRadius, kMass, kKilometre, kOwn };
inline constexpr const char* kLengthUnitNames[] = {"r_s", "M", "km"};  // in the panel and in the settings

inline constexpr double kMassOfSgrA_suns = 4.297e6;                     // GRAVITY Collaboration 2022
inline constexpr double kLeastMass_suns = 1e-6, kMostMass_suns = 1e12;  // as object.mass_suns

struct NumberStyle {
    LengthUnit unit = LengthUnit::kSchwarzschildRadius;
    double mass_suns = kMassOfSgrA_suns;  // for km and s
    bool decimal_comma = false;
    friend bool operator==(const NumberStyle&, const NumberStyle&) = default;
};

// What the wish means in a scene: the scene's mass if it has one, no unit in wormholes.
NumberStyle style_in(const Scene& scene, const Spacetime& spacetime, NumberStyle wish);

struct LengthScale {
    double one;        // r_s in the unit
    const char* name;  // of the unit; "": it has none
};
LengthScale length_scale(const NumberStyle& style);

// 921 600
std::string count_words(long long number);
// digits: significant ones. What is not finite is "none".
std::string number_words(double value, const NumberStyle& style, int digits = 6);
std::string fixed_words(double value, const NumberStyle& style, int decimals);
std::string length_words(double length, const NumberStyle& style, int digits = 6);  // given in r_s
// Given in r_s/c; in r_s/c, M/c, or s, min, h. Trailing zeros stay: the words of a running clock keep their width.
std::string time_words(double time, const NumberStyle& style, int digits = 6);

}  // namespace nullscope::viewer
