// How long the light of the sky takes (mino/kerr.glsl): T.
#ifdef NEEDS_PLACE_TIME
#include "mino/place.glsl"
#endif
#include "mino/trace.glsl"

float sky_delay(Trace trace) { return trace.travel_time; }

#ifdef NEEDS_PLACE_TIME
// How long light took from a place on the ray, whenever what it left is seen.
float place_light_time(Trace trace, RayPlace place, float tau) { return place.light_time; }
#endif
