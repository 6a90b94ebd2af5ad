// The sphere that keeps its size turns about the polar axis, or does not. objects[SPHERE_TURN]: its rate (rad by r_s/c), its angle now.
#include "core/trig.glsl"
#include "path/place"
#include "shared/objects.glsl"

#ifdef EFFECT_SPHERE_TURN
// Cosine and sine of its angle when the light left.
vec2 sphere_turn(RayPlace place) {
    vec4 turn = objects[SPHERE_TURN];
    vec2 swept = sine_cosine(turn.y - turn.x * place.delay);
    return vec2(swept.y, swept.x);
}

// Along with its texture's own rotation.
vec4 sphere_map(vec4 map, RayPlace place) {
    vec2 turn = sphere_turn(place);
    return vec4(map.x * turn.x - map.y * turn.y, map.y * turn.x + map.x * turn.y, map.z, map.w);
}

vec3 sphere_turned_back(vec3 v, RayPlace place) {
    vec2 turn = sphere_turn(place);
    return vec3(turn.x * v.x + turn.y * v.y, turn.x * v.y - turn.y * v.x, v.z);
}

// dx/dt of its surface.
vec3 sphere_velocity(int i, RayPlace place) { return objects[SPHERE_TURN].x * vec3(-place.at.y, place.at.x, 0.0); }
#else
vec4 sphere_map(vec4 map, RayPlace place) { return map; }
vec3 sphere_turned_back(vec3 v, RayPlace place) { return v; }
#endif
