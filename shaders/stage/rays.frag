// Where the rays of the picture's tiles go, a texel each.
#include "stage/corner_ray.glsl"

layout(location = 0) out vec4 ray;
#ifdef EFFECT_DISC
layout(location = 1) out vec4 places;
#endif
#ifdef CROSSINGS_TOLD
layout(location = 2) out vec4 moves;
#endif

void main() {
    CornerRay found = corner_ray(ivec2(gl_FragCoord.xy));
    ray = found.ray;
#ifdef EFFECT_DISC
    places = found.places;
#endif
#ifdef CROSSINGS_TOLD
    moves = found.moves;
#endif
}
