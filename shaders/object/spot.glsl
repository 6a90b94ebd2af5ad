// Hot spots in the disc. Three vectors of each [spot]: radius, angle now, Omega, angle between two; size^2, brightness, log2 of the temperature (K)
// and of its luminance; u^t, u^phi as disc_flow_row has them, 0, 0.
#include "core/trig.glsl"
#include "effect/black_body.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/objects.glsl"

// Its Gaussian, averaged over the pixel's footprint: the covariances of both add.
float spot_profile(float size2, vec2 off, vec2 along, vec2 across) {
    float xx = size2 + (along.x * along.x + across.x * across.x) * (1.0 / 12.0);
    float yy = size2 + (along.y * along.y + across.y * across.y) * (1.0 / 12.0);
    float xy = (along.x * along.y + across.x * across.y) * (1.0 / 12.0);
    float det = max(xx * yy - xy * xy, 1.0e-20);
    float square = (yy * off.x * off.x - 2.0 * xy * off.x * off.y + xx * off.y * off.y) / det;
    return size2 * inversesqrt(det) * exp(-0.5 * min(square, 160.0));
}

// Of the spots on one circular orbit, number k: what shines of the one that is nearest. delay: how long ago the light left that arrives now.
vec3 spot_orbit_light(int k, Trace trace, DiscCrossing crossing, float delay) {
    vec4 ring = objects[SPOT_FROM + 3 * k];
    vec4 glow = objects[SPOT_FROM + 3 * k + 1];
    float behind = ring.y - ring.z * delay;   // azimuth of the first, then
    vec2 outward = crossing.place / crossing.r;
    vec2 turned = vec2(outward.x * cos(behind) + outward.y * sin(behind), outward.y * cos(behind) - outward.x * sin(behind));
    float angle = bearing(turned.y, turned.x);
    angle -= ring.w * floor(angle / ring.w + 0.5);   // from the nearest
    vec2 middle = ring.x * vec2(outward.x * cos(angle) + outward.y * sin(angle), outward.y * cos(angle) - outward.x * sin(angle));
    float profile = spot_profile(glow.x, crossing.place - middle, crossing.along, crossing.across);
    if (profile < 1.0e-6) return vec3(0.0);
    vec4 velocity = objects[SPOT_FROM + 3 * k + 2];
    float g = disc_g(trace, crossing, vec3(velocity.x, velocity.y, 0.0));
    return seen_black_body(glow.z, g, glow.w) * (glow.y * profile);
}

vec3 spot_light(Trace trace, DiscCrossing crossing, float delay) {
    vec3 light = vec3(0.0);
    for (int k = 0; k < SPOT_COUNT; ++k) light += spot_orbit_light(k, trace, crossing, delay);
    return light;
}
