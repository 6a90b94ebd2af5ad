// The azimuth that a hole's rotation adds, which winds up next to its horizon and is kept apart (mino/medium.glsl).
#include "core/trig.glsl"

vec3 azimuth_turned(vec3 at, float turned) {
    vec2 turn = sine_cosine(turned);
    return vec3(turn.y * at.x - turn.x * at.y, turn.x * at.x + turn.y * at.y, at.z);
}

float azimuth_plus(float phi, float turn) { return phi + turn; }
