// Temperature and magnetic field by formulas of the scene file, of models that have none of their own.
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "path/azimuth"

// When the light left, r_s/c.
float medium_time(MediumPlace place) {
    float time = LAW_TIME;
#ifdef NEEDS_PLACE_LATE
    time -= place.delay;
#endif
    return time;
}

MediumMatter medium_warm(MediumPlace place, MediumMatter matter) {
    return medium_heated(medium_warmth(matter, azimuth_turned(place.at, place.turn), place.r, medium_time(place)));
}
