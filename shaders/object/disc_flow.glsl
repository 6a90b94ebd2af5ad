// A pattern that every ring carries round with its own speed. Wound up for ever it would be shredded: two copies of it, each of which
// starts half a life back and is wound until half a life ahead of where it is drawn, half a life apart; each fades in and out, and
// comes back turned. DISC_COPIES of them until they repeat.
#include "object/disc_cover.glsl"
#include "object/disc_orbit.glsl"
#include "path/disc"
#include "shared/frame.glsl"

#define DISC_COPIES 4096.0
#define DISC_GOLDEN 0.61803398875

vec2 disc_turned(vec2 v, float c, float s) { return vec2(c * v.x + s * v.y, c * v.y - s * v.x); }   // back by an angle

// delay: how long ago the light left that arrives now.
vec4 disc_flow(DiscCrossing crossing, float delay) {
    float zeta = 1.0 / crossing.r;
    vec2 orbit = disc_orbit(zeta);
    vec2 outward = crossing.place * zeta;
    vec2 around = vec2(-outward.y, outward.x);
    vec4 sum = vec4(0.0);
    float phase = frame.disc_winding.x - delay * frame.disc_winding.y;
    float part = phase - floor(phase);
    float copy = frame.disc_copy.x + floor(phase);
    float weight = 1.0 - abs(2.0 * part - 1.0);
    for (int i = 0; i < 2; ++i) {
        float age = (part - 0.5) / frame.disc_winding.y;
        float angle = orbit.x * age + 6.28318530717958647693 * fract(DISC_GOLDEN * (copy - DISC_COPIES * floor(copy / DISC_COPIES)));
        float shear = -zeta * orbit.y * age;   // across for each step outward
        vec2 a = crossing.along - around * (shear * dot(crossing.along, outward));
        vec2 b = crossing.across - around * (shear * dot(crossing.across, outward));
        float c = cos(angle);
        float s = sin(angle);
        sum += disc_cover(disc_turned(crossing.place, c, s), disc_turned(a, c, s), disc_turned(b, c, s)) * weight;
        weight = 1.0 - weight;   // the sum of both is 1, however coarse a float of many lives is
        copy += part < 0.5 ? 0.0 : 1.0;
        part += part < 0.5 ? 0.5 : -0.5;
    }
    return sum;
}
