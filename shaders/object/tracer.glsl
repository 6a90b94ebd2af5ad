// The Trace of a pixel's ray, and how long its light takes: where rays stay in planes, or about a rotating hole.
#ifdef EFFECT_SPIN
#include "object/spin_trace.glsl"
#else
#include "core/trace.glsl"
#ifdef EFFECT_DELAY
#include "core/delay.glsl"
#endif
#endif
