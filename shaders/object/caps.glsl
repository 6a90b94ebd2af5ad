// Hot caps on the sphere that keeps its size. Two vectors of each: where its middle is on a sphere of radius 1 that has not turned, and
// how far its rim is from there, as a chord (4: it covers all); factor on the primaries, log2 of its temperature (K).
#include "effect/black_body.glsl"
#include "object/solid.glsl"
#include "object/sphere_turn.glsl"
#include "shared/objects.glsl"

// The part of a pixel that a cap covers. away: from its middle.
float cap_cover(vec4 cap, vec3 outward, vec3 along, vec3 across) {
    vec3 apart = outward - cap.xyz;
    vec3 away = apart - dot(apart, outward) * outward;
    float size = max(sqrt(dot(away, away)), 1.0e-20);
    float wide = max((abs(dot(away, along)) + abs(dot(away, across))) / size, 1.0e-7);
    float inside = (cap.w - sqrt(dot(apart, apart))) * inversesqrt(max(1.0 - 0.25 * cap.w * cap.w, 1.0e-6));   // rad
    return clamp(0.5 + inside / wide, 0.0, 1.0);
}

// Over the light of sphere i. scale: log2 of what has brightness 1.
vec3 with_caps(vec3 light, int i, Trace trace, RayPlace place, float g, float scale) {
    SolidSpot spot = solid_spot(trace, place, place.outward);
    vec3 outward = sphere_turned_back(place.outward, place);
    vec3 along = sphere_turned_back(spot.along, place) / place.r;
    vec3 across = sphere_turned_back(spot.across, place) / place.r;
    float limb = g > 0.0 ? solid_limb(objects[5 * i + 2].w, spot.cosine) : 0.0;
    for (int k = 0; k < CAP_COUNT; ++k) {
        vec4 heat = objects[CAP_FROM + 2 * k + 1];
        vec3 hot = limb * vec3(heat.x, heat.y, heat.z) * seen_black_body(heat.w, max(g, 1.0e-30), scale);
        light = mix(light, hot, cap_cover(objects[CAP_FROM + 2 * k], outward, along, across));
    }
    return light;
}
