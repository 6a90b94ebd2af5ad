// Linear polarisation of a disc's light, as scenes give it.
#pragma once
#include <optional>

#include "base/vec.h"

namespace nullscope {

// Linear polarisation of a thermal disc's light and of its hot spots' (docs/light.md). kScattering: of Chandrasekhar's atmosphere, the electric
// vector across the disc's normal. kSynchrotron: of electrons in an ordered field, across the field, in the frame of the matter.
enum class Polarisation { kOff, kScattering, kSynchrotron };
enum class DiscField { kVertical, kRadial, kToroidal, kVector };
struct PolarisationSpec {
    Polarisation by = Polarisation::kOff;
    DiscField field = DiscField::kVertical;
    Vec3 vector{0, 0, 1};  // kVector: radial, azimuthal and vertical component, of any length above 0
    double spectral_index =
        1.0;  // alpha of synchrotron light ~ nu^-alpha: a fraction (alpha + 1)/(alpha + 5/3) is polarised ...
    double fraction = 1.0;  // ... times this, [0, 1]
    friend bool operator==(const PolarisationSpec&, const PolarisationSpec&) = default;
};

// Radial, azimuthal and vertical (north) component of the field's direction, unit; of scattering vertical: the electric vector is across
// the normal too.
inline Vec3 field_of(const PolarisationSpec& spec) {
    if (spec.by != Polarisation::kSynchrotron) return {0, 0, 1};
    if (spec.field == DiscField::kVector) return normalized(spec.vector);
    return {spec.field == DiscField::kRadial ? 1.0 : 0.0, spec.field == DiscField::kToroidal ? 1.0 : 0.0,
            spec.field == DiscField::kVertical ? 1.0 : 0.0};
}
// Of synchrotron light (Rybicki and Lightman, Radiative Processes, 1979, eq. 6.38: (p + 1)/(p + 7/3), p = 2 alpha + 1).
inline std::optional<double> polarised_fraction(const PolarisationSpec& spec) {
    if (spec.by != Polarisation::kSynchrotron) return {};
    return spec.fraction * (spec.spectral_index + 1.0) / (spec.spectral_index + 5.0 / 3.0);
}

}  // namespace nullscope
