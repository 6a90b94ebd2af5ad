// A power law of the frequency.
#include "generated/medium_matter"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

MediumLight medium_light(MediumPlace place, MediumMatter matter) {
    float log_g = log2(matter.g);
    MediumLight light;
#ifdef MEDIUM_ANY_DENSITY
    float log_density = medium_log_density(matter);
    float log_emission = log_density + LAW_EMITTED + LAW_EMITTED_POWER * log_g;
    float log_absorption = log_density + LAW_ABSORBED + LAW_ABSORBED_POWER * log_g;
    matter.inside = matter.density > 0.0 ? matter.inside : 0.0;
    light = medium_by_logarithms(matter, log_emission, log_absorption);
#else
    float density = matter.inside * matter.density / matter.over;
    light.emission = density * exp2(LAW_EMITTED_POWER * log_g) * frame.medium_colour.rgb;
    light.absorption = density * exp2(LAW_ABSORBED_POWER * log_g) * LAW_ABSORBED;
#endif
    return medium_stepped(matter, light);
}
