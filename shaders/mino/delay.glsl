// How long the light of the sky takes (mino/kerr.glsl): T.
#include "mino/trace.glsl"

float sky_delay(Trace trace) { return trace.travel_time; }
