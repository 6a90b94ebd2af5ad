// Objects whose mass and distance a scene has by their name ([object] name): this table and docs/scenes.md, which says where the numbers
// are from.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace nullscope {

inline constexpr double kLight_m_s = 299792458.0;
// r_s = 2 G M/c^2, m; G M_sun by IAU 2015 B3.
constexpr double schwarzschild_radius_m(double mass_suns) {
    constexpr double kSun_m3_s2 = 1.3271244e20;
    return 2.0 * mass_suns * kSun_m3_s2 / (kLight_m_s * kLight_m_s);
}

enum class ObjectName { kOther, kM87, kSgrA, kCygnusX1, kGargantua };  // kOther: of the scene's own numbers

struct SkyPlace {
    double right_ascension_deg, declination_deg;  // ICRS
};

struct KnownObject {
    std::string_view key;   // in scene files
    std::string_view name;  // as people write it, in ASCII
    double mass_suns, distance_pc;
    std::optional<SkyPlace> place;  // nothing: it is in no catalogue
};

// In the order of ObjectName, without kOther.
inline constexpr std::array<KnownObject, 4> kKnownObjects = {{
    {"m87", "M87*", 6.5e9, 16.8e6, SkyPlace{187.7059308, 12.3911233}},
    {"sgr-a", "Sgr A*", 4.297e6, 8277.0, SkyPlace{266.4168371, -29.0078106}},
    {"cygnus-x-1", "Cygnus X-1", 21.2, 2220.0, SkyPlace{299.5903154, 35.2016067}},
    {"gargantua", "Gargantua", 1e8, 3e9, std::nullopt},
}};

// nullptr: kOther.
constexpr const KnownObject* known_object(ObjectName name) {
    return name == ObjectName::kOther ? nullptr : &kKnownObjects[static_cast<std::size_t>(name) - 1];
}

}  // namespace nullscope
