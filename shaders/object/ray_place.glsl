// The RayPlace on a ray: where rays stay in planes, or about a rotating hole.
#ifdef EFFECT_SPIN
#include "object/spin_place.glsl"
#else
#include "object/place.glsl"
#endif
