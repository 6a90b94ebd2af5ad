// How a ray of a list starts where rays stay in planes: each in its own meridian (src/shadercore/listed_ray.h).
#include "shared/frame.glsl"

void start_ray(vec4 start, vec4 radial, vec4 meridian, vec4 ray) {
    vec3 e = vec3(radial.x, radial.y, radial.z);
    vec3 m = vec3(meridian.x, meridian.y, meridian.z);
    frame.polar_0 = start;
    frame.radial = vec4(e, frame.radial.w);
    frame.meridian = vec4(m, 0.0);
    frame.transverse = vec4(cross(e, m), 0.0);
    frame.ray_0 = ray;
#ifdef EFFECT_DISC
    frame.disc_normal.w = radial.w;
#endif
}
