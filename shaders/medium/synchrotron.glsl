// Thermal synchrotron radiation of relativistic electrons, in units of 1e-20 erg/(s Hz sr) an electron a cm^3.
// In a field of one direction: Leung, Gammie and Noble 2011 (ApJ 737, 21); mean over all directions: Mahadevan, Narayan and Yi
// 1996 (ApJ 465, 327), for relativistic electrons. COLDEST_K and FIELD_DIRECTED: generated/medium_matter.
#include "generated/medium_matter"
#include "medium/electrons.glsl"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/planck.glsl"
#include "shared/frame.glsl"

// log2 of that. way: of the light, where the matter rests; frequency in GHz.
float log2_synchrotron(MediumMatter matter, vec3 way, float frequency) {
    float theta = clamp(matter.temperature, COLDEST_K, 1.0e14) / ELECTRON_K;
    float gyro = GYRO_GHZ * clamp(matter.field, 1.0e-6, 1.0e9);
    float log_bessel = 1.0 + 2.0 * log2(theta) + log2(bessel_part(1.0 / theta));   // K_2(1/theta) exp(1/theta)
#ifdef FIELD_DIRECTED
    float sine = clamp(length(cross(way, matter.field_way)), 1.0e-3, 1.0);
    float log_scale = log2((2.0 / 9.0) * gyro * sine) + 2.0 * log2(theta);
    float log_x = log2(frequency) - log_scale;
    float third = exp2(log_x * (1.0 / 3.0));
    // root = sqrt(x) + 2^(11/12) x^(1/6)
    float log_root = log_x * (1.0 / 6.0) + log2(third + 1.88774862536);
    return log2(1.13968) + log_scale - log_bessel + 2.0 * log_root + LOG2_E * (1.0 / theta - third);
#else
    float log_x = log2((2.0 / 3.0) * frequency) - log2(gyro) - 2.0 * log2(theta);
    float third = exp2(log_x * (1.0 / 3.0));
    float quarter = exp2(log_x * -0.25);
    return log2(0.444305 * 4.0505) + log2(frequency) - log_bessel - log_x * (1.0 / 6.0) + log2(1.0 + quarter * (0.4 + 0.5316 * quarter)) +
           LOG2_E * (1.0 / theta - 1.8899 * third);
#endif
}

MediumLight medium_light(MediumPlace place, MediumMatter matter) {
    float log_g = log2(matter.g);
    float log_density = medium_log_density(matter);
    vec3 seen = medium_seen(place, matter);
    float frequency = LAW_FREQUENCY * exp2(-LAW_SHIFT * log_g);
    float log_emitted = log_density + LAW_UNIT + log2_synchrotron(matter, seen, frequency) - log_g;
    float log_black = LAW_BLACK - 2.0 * LAW_SHIFT * log_g + log2_planck_temperature(matter.temperature, frequency);
    float log_emission = log_emitted + LAW_BEAMING * log_g;
    float log_absorption = log_emitted - log_black;
    bool shines = matter.density > 0.0 && matter.temperature >= COLDEST_K && matter.field > 0.0;
    matter.inside = shines ? matter.inside : 0.0;
    return medium_stepped(matter, medium_by_logarithms(matter, log_emission, log_absorption));
}

#ifdef MEDIUM_STOKES
#include "medium/synchrotron_stokes.glsl"
#endif
