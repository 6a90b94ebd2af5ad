// Thermal bremsstrahlung of hydrogen (Rybicki and Lightman 1979, 5.14), with their Gaunt factor of low frequencies where that is above 1; in
// units of 1e-20 erg/(s cm^3 Hz sr).
#include "generated/medium_matter"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "medium/planck.glsl"

#define BREMSSTRAHLUNG_LOG2 -60.671870   // log2 of 5.4444e-19, at 1 K
#define GAUNT 0.55132890               // sqrt(3)/pi

MediumLight medium_light(MediumPlace place, MediumMatter matter) {
    float log_g = log2(matter.g);
    float frequency = LAW_FREQUENCY * exp2(-LAW_SHIFT * log_g);
    float t = max(matter.temperature, 1.0);
    float gaunt = max(GAUNT * (17.7 - 20.723266 + 1.5 * log(t) - log(frequency)), 1.0);   // ln 1e9: frequency in GHz
    float log_emitted = 2.0 * medium_log_density(matter) + LAW_UNIT + BREMSSTRAHLUNG_LOG2 + log2(gaunt) - 0.5 * log2(t) -
                        LOG2_E * PLANCK_K * frequency / t - log_g;
    float log_black = LAW_BLACK - 2.0 * LAW_SHIFT * log_g + log2_planck_temperature(t, frequency);
    matter.inside = matter.density > 0.0 ? matter.inside : 0.0;
    return medium_stepped(matter, medium_by_logarithms(matter, log_emitted + LAW_BEAMING * log_g, log_emitted - log_black));
}
