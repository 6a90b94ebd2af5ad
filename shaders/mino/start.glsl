// How a ray of a list starts about a rotating hole (src/shadercore/listed_ray.h).
#include "shared/frame.glsl"

void start_ray(vec4 start, vec4 radial, vec4 meridian, vec4 ray) {
    frame.spin_place = start;
    frame.ray_0 = ray;
#ifdef EFFECT_SPIN_RING
    frame.ring_peak = vec4(radial.x, 0.0, 0.0, 0.0);
#endif
}
