// Light of bodies that shine by their heat. Two vectors of each: factor on the primaries, log2 of its temperature (K); log2 of its brightness,
// sum and product of A = 1 - sum/r + product/r^2, 1 with gravity's part of g, 2 with that of motion.
#include "effect/black_body.glsl"
#include "generated/bodies_shift"
#include "shared/objects.glsl"

vec3 glow_light(int at, float g) {
    vec4 heat = objects[at];
    vec3 light = seen_black_body(heat.w, max(g, 1.0e-30), objects[at + 1].x);
    return g > 0.0 ? vec3(heat.x, heat.y, heat.z) * light : vec3(0.0);
}
