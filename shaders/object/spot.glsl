// Hot spots in the disc. Three vectors of each [spot]: radius, angle now, Omega, angle between two; size^2, brightness, log2 of the temperature (K)
// and of its luminance; u^t, u^phi as disc_flow_row has them, the lapses of its matter and of light (object/disc_polarisation.glsl).
#include "core/trig.glsl"
#include "effect/black_body.glsl"
#include "object/disc_stokes.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/objects.glsl"

float spot_cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Its Gaussian, averaged over the pixel's footprint: the covariances of both add. Lengths in units of the larger of both, and determinants as sums
// of squares: footprints on wide discs are up to 1e10 of a spot's size.
float spot_profile(float size2, vec2 off, vec2 along, vec2 across) {
    float pixel2 = (dot(along, along) + dot(across, across)) * (1.0 / 12.0);
    float unit2 = max(size2, pixel2);
    float scale = inversesqrt(unit2);
    float small = size2 / unit2;
    vec2 a = (0.28867513459 * scale) * along;   // 1/sqrt(12)
    vec2 b = (0.28867513459 * scale) * across;
    vec2 c = scale * off;
    float area = spot_cross(a, b);
    float beside_a = spot_cross(a, c);
    float beside_b = spot_cross(b, c);
    float det = max(small * (small + pixel2 / unit2) + area * area, 1.0e-20);
    float square = (small * dot(c, c) + beside_a * beside_a + beside_b * beside_b) / det;
    return small * inversesqrt(det) * exp(-0.5 * min(square, 160.0));
}

#ifdef NEEDS_POLARISATION
// velocity: u^t, u^phi, lapses.
vec2 spot_polarised(Trace trace, DiscCrossing crossing, vec4 velocity) {
    return disc_polarised(trace, crossing, vec3(velocity.x, velocity.y, 0.0), vec2(velocity.z, velocity.w), 1.0);
}
#endif

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
    return polarised_light(seen_black_body(glow.z, g, glow.w) * (glow.y * profile), spot_polarised(trace, crossing, velocity));
}

vec3 spot_light(Trace trace, DiscCrossing crossing, float delay) {
    vec3 light = vec3(0.0);
    for (int k = 0; k < SPOT_COUNT; ++k) light += spot_orbit_light(k, trace, crossing, delay);
    return light;
}
