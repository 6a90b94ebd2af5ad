// Matter whose density, temperature, magnetic field and motion are formulas of the scene file.
#ifdef EFFECT_SPIN
#include "core/trig.glsl"
#endif
#include "generated/medium_matter"
#include "medium/emission.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

MediumLight medium_light(MediumPlace place) {
    float time = frame.medium_extent.w;
#ifdef NEEDS_PLACE_LATE
    time -= place.delay;
#endif
    vec3 at = place.at;
#ifdef EFFECT_SPIN
    vec2 turn = sine_cosine(place.turn);
    at = vec3(turn.y * at.x - turn.x * at.y, turn.x * at.x + turn.y * at.y, at.z);
#endif
    return medium_emission(place, medium_matter(at, place.r, time), medium_inside(place));
}
