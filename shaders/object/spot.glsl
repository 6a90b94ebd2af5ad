// Hot spots on one circular orbit in the disc: what shines of the one that is nearest.
#include "core/trig.glsl"
#include "effect/black_body.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/frame.glsl"

// Its Gaussian, averaged over the pixel's footprint: the covariances of both add.
float spot_profile(vec2 off, vec2 along, vec2 across) {
    float size2 = frame.spot_look.x;
    float xx = size2 + (along.x * along.x + across.x * across.x) * (1.0 / 12.0);
    float yy = size2 + (along.y * along.y + across.y * across.y) * (1.0 / 12.0);
    float xy = (along.x * along.y + across.x * across.y) * (1.0 / 12.0);
    float det = max(xx * yy - xy * xy, 1.0e-20);
    float square = (yy * off.x * off.x - 2.0 * xy * off.x * off.y + xx * off.y * off.y) / det;
    return size2 * inversesqrt(det) * exp(-0.5 * min(square, 160.0));
}

// late: how long ago the light left that arrives now.
vec3 spot_light(Trace trace, DiscCrossing crossing, float late) {
    float behind = frame.spot.y - frame.spot.z * late;   // azimuth of the first, then
    vec2 outward = crossing.place / crossing.r;
    vec2 turned = vec2(outward.x * cos(behind) + outward.y * sin(behind), outward.y * cos(behind) - outward.x * sin(behind));
    float angle = arc_tangent2(abs(turned.y), turned.x) * (turned.y < 0.0 ? -1.0 : 1.0);
    angle -= frame.spot.w * floor(angle / frame.spot.w + 0.5);   // from the nearest
    vec2 middle = frame.spot.x * vec2(outward.x * cos(angle) + outward.y * sin(angle), outward.y * cos(angle) - outward.x * sin(angle));
    float profile = spot_profile(crossing.place - middle, crossing.along, crossing.across);
    if (profile < 1.0e-6) return vec3(0.0);
    float g = disc_g(trace, crossing, vec3(frame.spot_motion.x, frame.spot_motion.y, 0.0));
    return seen_black_body(frame.spot_look.z, g, frame.spot_look.w) * (frame.spot_look.y * profile);
}
