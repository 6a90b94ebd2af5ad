// Turbulent gas: octaves of noise in rings of equal ln r (core/ring_noise.glsl), each of which goes round at its own speed, sheared along
// trailing spirals. Every octave moves the next one's rings in and out, which curls its filaments.
//
// Light is multiplied by (1 + c n)^2 over its mean 1 + c^2/3 for each octave, what shines through by (1 - c n)^2 over the same. An
// octave finer than the pixel's footprint is at that mean.
#include "core/ring_noise.glsl"
#include "core/trig.glsl"
#ifdef EFFECT_DISC_FLOW
#include "object/disc_orbit.glsl"
#endif
#include "path/disc"
#include "shared/frame.glsl"

#define GAS_OCTAVES 9
#define GAS_CELLS 8.0     // around the axis, of the coarsest octave (core/ring_noise.glsl)
#define GAS_RING 0.3      // its rings' distance in ln r
#define GAS_CURL 0.4      // by how much of that distance an octave moves the next ones
#define GAS_SHIFT 0.37    // of the rings from octave to octave
#define GAS_WIDEST 1.75   // cells or rings: an octave is not seen in wider pixels, and all of it in those narrower by 1

struct DiscGas {
    float light;   // factors of mean 1, on light
    float gaps;    // ... and on what shines through
};

// Turns that a ring has made until the light left.
float gas_turned(float x, float delay) {
#ifdef EFFECT_DISC_FLOW
    return fract(disc_orbit(exp(-x)).x * (frame.disc_gas.w - delay) * 0.15915494309189533577);
#else
    return 0.0;
#endif
}

// What shines through, of mean 1 - opacity: thin gas covers as much as it shines, thick gas has gaps.
float disc_gas_gaps(DiscGas gas, float opacity) {
    return clamp(mix(1.0 - opacity * gas.light, (1.0 - opacity) * gas.gaps, opacity * opacity), 0.0, 1.0);
}

// The gas at one place: its ln r, and turns around the axis; wide: of the footprint there, in cells or rings of the coarsest octave. As
// disc_gas.
DiscGas disc_gas_at(float x, float turns, float wide, float delay, float whole) {
    float step = GAS_RING;
    float moved = x;
    float fall = 1.0;
    int level = 0;
    DiscGas gas = DiscGas(1.0, 1.0);
    do {   // tested at the end, see disc_cover
        float shift = GAS_SHIFT * float(level);
        float at = moved / step + shift;
        float ring = floor(at);
        vec2 weights = ring_weights(at - ring);
        float middle = (ring - shift) * step;
        float inner = turns + frame.disc_gas.y * (x - middle) - gas_turned(middle, delay);
        float outer = turns + frame.disc_gas.y * (x - middle - step) - gas_turned(middle + step, delay);
        float noise = weights.x * ring_noise(int(ring), level, inner) + weights.y * ring_noise(int(ring) + 1, level, outer);
        float share = mix(1.0, min(0.35 + 0.25 * float(level), 1.0), whole);
        float c = frame.disc_gas.x * fall * share;
        float seen = clamp(GAS_WIDEST - wide, 0.0, 1.0);
        float scale = seen / (1.0 + c * c * (1.0 / 3.0));
        gas.light *= 1.0 - seen + scale * (1.0 + c * noise) * (1.0 + c * noise);
        gas.gaps *= 1.0 - seen + scale * (1.0 - c * noise) * (1.0 - c * noise);
        moved += GAS_CURL * step * noise;
        step *= 0.5;
        wide *= 2.0;
        fall *= 0.82;
        level += 1;
    } while (level < GAS_OCTAVES && wide < GAS_WIDEST);
    return gas;
}

// The mean of two places along the longer side of the footprint. delay: how long ago the light left. whole: of the disc's opacity, less
// than 1 towards soft rims, which are made of clumps.
DiscGas disc_gas(DiscCrossing crossing, float delay, float whole) {
    float x = log(crossing.r);
    float zeta = 1.0 / crossing.r;
    vec2 outward = crossing.place * zeta;
    vec2 around = vec2(-outward.y, outward.x) * 0.15915494309189533577;
    float azimuth = bearing(outward.y, outward.x);
    float turns = azimuth * 0.15915494309189533577 - frame.disc_gas.z;
    vec2 along = vec2(dot(crossing.along, outward), dot(crossing.along, around)) * zeta;
    vec2 across = vec2(dot(crossing.across, outward), dot(crossing.across, around)) * zeta;
    vec2 cells = vec2(along.y, across.y) + vec2(along.x, across.x) * frame.disc_gas.y;
    vec2 rings = vec2(along.x, across.x);
    vec2 wide2 = GAS_CELLS * GAS_CELLS * cells * cells + rings * rings / (GAS_RING * GAS_RING);
    vec2 longer = 0.25 * (wide2.x > wide2.y ? along : across);
    float wide = sqrt(max(0.25 * max(wide2.x, wide2.y), min(wide2.x, wide2.y)));
    longer = wide < GAS_WIDEST ? longer : vec2(0.0);   // nothing of it is seen, and far out its rate is no number
    DiscGas sum = DiscGas(0.0, 0.0);
    float side = -1.0;
    do {
        DiscGas gas = disc_gas_at(x + side * longer.x, turns + side * longer.y, wide, delay, whole);
        sum.light += 0.5 * gas.light;
        sum.gaps += 0.5 * gas.gaps;
        side += 2.0;
    } while (side < 2.0);
    return sum;
}
