// The sky at the other end of a wormhole where the near one is dark or painted (both: object/celestial_sphere.glsl).
#include "path/trace"

uniform samplerCube other_side_texture;

vec3 other_side(Trace trace, float level) { return textureLod(other_side_texture, trace.sky, level).rgb; }
