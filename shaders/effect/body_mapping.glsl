// Texture coordinates of directions from a body's middle: u to the right, v from the top, both 0 ... 1.

// turn: cosine and sine of the look's rotation about the polar axis.
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
    vec2 uv = (face + 0.5 + 0.5 * place) * vec2(0.33333333333, 0.5);
    return uv;
}

// Difference of two texture coordinates of neighbouring places: across a seam it counts as small.
vec2 mapping_step(vec2 to, vec2 from) {
    vec2 step = to - from;
    step.x -= floor(step.x + 0.5);
    return dot(step, step) > 0.0225 ? vec2(0.002) : step;
}
