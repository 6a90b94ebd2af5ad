// Texture coordinates of directions from a body's middle: u to the right, v from the top, both 0 ... 1.
#include "core/trig.glsl"

// turn: cosine and sine of the texture's rotation about the polar axis.
vec3 mapping_turned(vec3 d, vec2 turn) { return vec3(turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x, d.z); }

float mapping_azimuth(vec3 d) {
    float angle = arc_tangent2(abs(d.y), d.x) * 0.15915494309189533577;
    return d.y < 0.0 ? -angle : angle;   // turns, -1/2 ... 1/2
}

vec2 mapping_equirectangular(vec3 d) {
    return vec2(0.5 + mapping_azimuth(d), arc_tangent2(sqrt(d.x * d.x + d.y * d.y), d.z) * 0.31830988618379067154);
}

// v beyond 0 ... 1 outside of the band. limit: the band's latitude.
vec2 mapping_band(vec3 d, float limit) {
    float polar = arc_tangent2(sqrt(d.x * d.x + d.y * d.y), d.z);
    return vec2(0.5 + mapping_azimuth(d), 0.5 - 0.5 * (1.57079632679489661923 - polar) / limit);
}

vec2 mapping_caps(vec3 d) {
    float rho = sqrt(d.x * d.x + d.y * d.y);
    float from_pole = arc_tangent2(rho, abs(d.z)) * 0.63661977236758134308;   // 1 at the equator
    vec2 outward = vec2(d.x, d.y) / max(rho, 1.0e-20) * (0.25 * from_pole);
    // Azimuth 0 points down on the northern half and up on the southern, and grows to the right on both.
    return d.z < 0.0 ? vec2(0.75 + outward.y, 0.5 - 2.0 * outward.x) : vec2(0.25 + outward.y, 0.5 + 2.0 * outward.x);
}

vec2 mapping_cube(vec3 d) {
    vec3 a = abs(d);
    vec2 face;
    vec2 place;
    if (a.x >= a.y && a.x >= a.z) {
        face = vec2(d.x < 0.0 ? 1.0 : 0.0, 0.0);
        place = vec2(d.x < 0.0 ? -d.y : d.y, -d.z) / max(a.x, 1.0e-20);
    } else if (a.y >= a.z) {
        face = d.y < 0.0 ? vec2(0.0, 1.0) : vec2(2.0, 0.0);
        place = vec2(d.y < 0.0 ? d.x : -d.x, -d.z) / max(a.y, 1.0e-20);
    } else {
        face = vec2(d.z < 0.0 ? 1.0 : 2.0, 1.0);
        place = vec2(d.y, d.z < 0.0 ? -d.x : d.x) / max(a.z, 1.0e-20);
    }
    return (face + 0.5 + 0.5 * place) * vec2(0.33333333333, 0.5);
}

// The sky, seen from inside: columns grow to the left of azimuth, as an equirectangular image's.
vec2 mapping_inside(vec3 d) {
    return vec2(0.5 - mapping_azimuth(d), arc_tangent2(sqrt(d.x * d.x + d.y * d.y), d.z) * 0.31830988618379067154);
}

// How it changes, exactly; d: unit to rounding. Round a pole the azimuth has no bound: POLE_LEAST keeps it finite.
#define POLE_LEAST 1.0e-12
vec2 mapping_inside_step(vec3 d, vec3 side) {
    float rho2 = max(d.x * d.x + d.y * d.y, POLE_LEAST);
    float outward = (d.x * side.x + d.y * side.y) * inversesqrt(rho2);
    return vec2((d.y * side.x - d.x * side.y) / rho2 * 0.15915494309189533577,
                (d.z * outward - side.z * sqrt(rho2)) * 0.31830988618379067154);
}

// A disc: azimuth, and radius from rim to rim.
vec2 mapping_polar(vec3 d, float inner, float outer) {
    return vec2(0.5 + mapping_azimuth(d), (sqrt(d.x * d.x + d.y * d.y) - inner) / (outer - inner));
}

vec2 mapping_polar_step(vec3 d, vec3 side, float width) {
    float rho2 = max(d.x * d.x + d.y * d.y, POLE_LEAST);
    return vec2((d.x * side.y - d.y * side.x) / rho2 * 0.15915494309189533577, (d.x * side.x + d.y * side.y) * inversesqrt(rho2) / width);
}

// Difference of two texture coordinates of neighbouring places: across a seam, and next to a pole, where it is longer than their distance of at
// least so many radii explains, it counts as small.
vec2 mapping_step(vec2 to, vec2 from, float least) {
    vec2 step = to - from;
    step.x -= floor(step.x + 0.5);
    float most = max(0.15, 0.5 * least);
    return dot(step, step) > most * most ? vec2(0.002) : step;
}
