// Matter whose density, temperature, magnetic field and motion are formulas of the scene file.
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/sphere.glsl"
#include "medium/warmth.glsl"
#include "path/azimuth"

MediumMatter medium_matter(MediumPlace place) {
    MediumMatter matter = medium_formulas(medium_in_sphere(place), azimuth_turned(place.at, place.turn), place.r, medium_time(place));
    matter.density *= FORMULA_DENSITY;
    return medium_moving(place, medium_warm(place, matter), matter.velocity);
}
