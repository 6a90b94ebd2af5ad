// A black body, with one opacity for all colours.
#include "effect/black_body.glsl"
#include "generated/medium_matter"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

vec3 medium_glow(MediumMatter matter) { return seen_black_body(matter.heat, matter.g, LAW_BRIGHT); }

MediumLight medium_light(MediumPlace place, MediumMatter matter) {
    MediumLight light;
    light.absorption = min(matter.inside * matter.density * LAW_OPACITY / (matter.over * matter.g), EMISSION_MOST);
    light.emission = min(light.absorption * frame.medium_colour.rgb * medium_glow(matter), vec3(EMISSION_MOST));
    return medium_stepped(matter, light);
}
