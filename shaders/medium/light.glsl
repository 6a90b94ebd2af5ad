// What emission laws share.
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

#define EMISSION_DEEPEST 0.7    // optical depth of a sample
#define EMISSION_MOST 1.0e30
#define EMISSION_MOST_LOG2 99.0

float emission_number(float logarithm) { return logarithm > -120.0 ? exp2(min(logarithm, EMISSION_MOST_LOG2)) : 0.0; }

// Of logarithms: what dense matter emits, and what each of its particles does, may both have no room in a float.
MediumLight medium_by_logarithms(MediumMatter matter, float log_emission, float log_absorption) {
    float beyond = max(log_absorption - EMISSION_MOST_LOG2, 0.0);   // opaque, and as bright
    MediumLight light;
    light.absorption = matter.inside * emission_number(log_absorption - beyond);
    light.emission = matter.inside * emission_number(log_emission - beyond) * frame.medium_colour.rgb;
    return light;
}

float medium_log_density(MediumMatter matter) { return log2(max(matter.density / matter.over, 1.0e-37)); }

MediumLight medium_stepped(MediumMatter matter, MediumLight light) {
    light.step = clamp(EMISSION_DEEPEST / max(light.absorption * matter.g, 1.0e-6), matter.shortest, matter.longest);
    return light;
}
