// Matter whose density, temperature, magnetic field and motion are formulas of the scene file.
#include "generated/medium_matter"
#include "medium/emission.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

MediumLight medium_light(MediumPlace place) {
    float time = frame.medium_extent.w;
#ifdef NEEDS_PLACE_LATE
    time -= place.delay;
#endif
    return medium_emission(place, medium_matter(place.at, place.r, time), medium_inside(place));
}
