// Synchrotron radiation of electrons that are not thermal, in units of 1e-20 erg/(s Hz sr) an electron a cm^3: sqrt(3)/2 e^2/c nu_B sine J, and what
// they absorb, that over 2 m nu^2 with A in place of J (medium/electron_table.glsl).
#include "generated/medium_matter"
#include "medium/electron_table.glsl"
#include "medium/electrons.glsl"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

#ifdef FIELD_DIRECTED
float electron_sine(vec3 way, vec3 field_way) { return clamp(length(cross(way, field_way)), 1.0e-3, 1.0); }
#else
float electron_sine(vec3 way, vec3 field_way) { return 1.0; }
#endif

// log2 of what they emit.
float log2_synchrotron(ElectronScale scale, float sine, float shape) {
    return ELECTRON_LOG2 + log2(scale.gyro * sine) + scale.number + shape;
}

MediumLight medium_light(MediumPlace place, MediumMatter matter) {
    float log_g = log2(matter.g);
    float sine = electron_sine(medium_seen(place, matter), matter.field_way);
    ElectronScale scale = electron_scale(matter, LAW_FREQUENCY * exp2(-LAW_SHIFT * log_g), sine);
    vec2 shape = electron_row(scale.at, 0).xy;
    float log_emitted = medium_log_density(matter) + LAW_UNIT + log2_synchrotron(scale, sine, shape.x) - log_g;
    // J m c^2/(A k) is the temperature of a black body as bright, by Rayleigh and Jeans' law.
    float log_source = LAW_BLACK - 2.0 * LAW_SHIFT * log_g + log2(ELECTRON_K) + shape.x - shape.y + scale.wide;
    bool shines = matter.density > 0.0 && matter.field > 0.0;
#ifdef ELECTRONS_KAPPA
    shines = shines && matter.temperature >= COLDEST_K;
#endif
    matter.inside = shines ? matter.inside : 0.0;
    return medium_stepped(matter, medium_by_logarithms(matter, log_emitted + LAW_BEAMING * log_g, log_emitted - log_source));
}

#ifdef MEDIUM_STOKES
#include "medium/electrons_stokes.glsl"
#endif
