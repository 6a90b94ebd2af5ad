// The DiscCrossing of a ray and the disc: where rays stay in planes, or about a rotating hole.
#ifdef EFFECT_SPIN
#include "object/spin_disc.glsl"
#else
#include "object/disc.glsl"
#endif
