// A soft disc: gas in circular orbits, Gaussian across the plane, with noise in rings (core/ring_noise.glsl) that go round at their own
// rates. Its temperature falls as r^(-3/4).
#include "core/ring_noise.glsl"
#include "core/trig.glsl"
#include "generated/medium_matter"
#include "medium/circles.glsl"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "path/trace"

#define SOFT_OCTAVES 4
#define SOFT_RING 0.3      // distance of the coarsest octave's rings in ln(rho)
#define SOFT_TILT 0.7      // rings by which one height is off the one below, outward and inward in turn, in each octave 1.6 times as many:
#define SOFT_LEAN 0.35     //   they are cones. And cells, likewise
#define SOFT_CURL 0.4      // by how much of the rings' distance an octave moves the next ones
#define SOFT_SHIFT 0.37    // of rings from octave to octave
#define SOFT_CELLS_A_RADIAN 1.2732395447351628
#define SOFT_WIDEST 1.75   // rings: an octave is not seen where pixel and sample are wider, and all of it where they are narrower by 1
#define SOFT_HIGHEST 3.5   // scale heights
#define MEDIUM_WEDGE (SOFT_HIGHEST * GAS_THICKNESS * GAS_SURFACE)   // |cos(theta)| of its surfaces
#define SOFT_STEP 0.5      // scale heights, across the plane
#define SOFT_FLATTEST 0.5  // rays that go across the plane less than this have no longer steps
#define SOFT_THIN 0.7      // by how much steps are longer for each scale height more
#define SOFT_DEEPEST 0.4   // optical depth of a step
#define SOFT_AHEAD 1.5     // steps: how far on denser gas is near
#define SOFT_ACROSS 0.2    // of ln(rho), a step: temperature falls
#define SOFT_TRAIL 0.128   // turns by which filaments trail along a step: a cell of the coarsest octave
#define SOFT_RIM 0.2       // of a rim, across it

// Omega of circular orbits at 1/zeta, as object/disc_orbit.glsl.
float gas_rate(float zeta) {
    float w = sqrt(max(zeta * zeta * zeta * (GAS_RATE - GAS_RATE_CHARGE * zeta), 0.0));
    return GAS_SENSE * w / (1.0 + GAS_SENSE * path_spin() * w);
}

#ifdef EFFECT_MEDIUM_MOTION
// Turns that a ring at 1/zeta has made.
float gas_moved(float zeta, float age) { return fract(gas_rate(zeta) * age * 0.15915494309189533577); }
#endif

// The density's factor, of mean 1. x: ln(rho); y: scale heights. wide: rings of the coarsest octave that pixel and sample cover; up: and scale
// heights. An octave that they are too wide for is at its mean.
float gas_clumps(float x, float y, float turns, float wide, float up, float age) {
    float step = SOFT_RING;
    float moved = x;
    float lean = SOFT_LEAN * 0.125;
    float tilt = SOFT_TILT;
    float contrast = GAS_CONTRAST;
    float density = 1.0;
    float seen = 1.0;
    int level = 0;
#ifdef EFFECT_MEDIUM_MOTION
    float apart = exp(-SOFT_RING);   // of zeta, of two rings
#endif
    do {   // tested at the end, see disc_cover
        float shift = SOFT_SHIFT * float(level);
        float at = moved / step + shift + tilt * y;
        float ring = floor(at);
        vec2 weights = ring_weights(at - ring);
        float middle = (ring - shift) * step;
        // Turns from where the rings' first cells were when the light left, trailing with ln(rho).
        float from = lean * y + turns + GAS_WINDING * (x - middle);
        float next = from - GAS_WINDING * step;
#ifdef EFFECT_MEDIUM_MOTION
        float zeta = exp(-middle);
        from -= gas_moved(zeta, age);
        next -= gas_moved(zeta * apart, age);
        apart = sqrt(apart);
#endif
        float noise = weights.x * ring_noise(int(ring), level, from) + weights.y * ring_noise(int(ring) + 1, level, next);
        seen = clamp(SOFT_WIDEST - wide - abs(tilt) * up, 0.0, 1.0);
        float c = contrast * seen;
        density *= (1.0 + c * noise) * (1.0 + c * noise) / (1.0 + c * c * (1.0 / 3.0));
        moved += SOFT_CURL * step * noise;
        step *= 0.5;
        lean *= -0.8;
        tilt *= -1.6;
        wide *= 2.0;
        contrast *= 0.82;
        level += 1;
    } while (level < SOFT_OCTAVES && seen > 0.0);
    return density;
}

float gas_rim(float inside) {
    float rim = clamp(inside * GAS_RIM, 0.0, 1.0);
    return rim * rim * (3.0 - 2.0 * rim);
}

// How long the next step may be. inside: of the rims, in ln(rho); y: scale heights; dense: optical depth for each r_s in the plane, inside.
float gas_step(MediumPlace place, float rho, float inside, float y, float dense) {
    vec3 way = place.way * inversesqrt(max(dot(place.way, place.way), 1.0e-20));
    float scale = max(rho, GAS_INNER);
    float height = GAS_THICKNESS * scale;
    float thin = 1.0 + SOFT_THIN * clamp(abs(y) - 1.0, 0.0, SOFT_HIGHEST - 1.0);
    float step = SOFT_STEP * thin * height / max(abs(way.z), SOFT_FLATTEST);
    float out_way = (place.at.x * way.x + place.at.y * way.y) / (rho * scale);   // of ln(rho)
    float width = 1.0 / GAS_RIM;
    float across = min(SOFT_RIM * width + max(inside - width, 0.0), min(SOFT_ACROSS, SOFT_TRAIL / max(abs(GAS_WINDING), 1.0e-3)));
    step = min(step, across / max(abs(out_way), 1.0e-6));
    step = min(step, SOFT_DEEPEST / max(dense * gas_rim(inside) * exp(-0.5 * y * y), 1.0e-6));
    // The densest gas that is near on the way.
    float on = SOFT_AHEAD * step;
    float ahead = y + on * (way.z / height - y * out_way);
    float nearest = ahead * y > 0.0 ? min(abs(ahead), abs(y)) : 0.0;
    float most = SOFT_DEEPEST / max(dense * gas_rim(inside + on * abs(out_way)), 1.0e-6);
    return min(step, sqrt(step * most) * exp(0.25 * min(nearest * nearest, 40.0)));
}

MediumMatter medium_matter(MediumPlace place) {
    float rho = max(place.r * sqrt(max(1.0 - place.cosine * place.cosine, 0.0)), 1.0e-6);
    float height = GAS_THICKNESS * rho;
    float y = place.r * place.cosine / height;
    float x = log(rho);
    float inside = min(x - GAS_LOG_INNER, GAS_LOG_OUTER - x);
    float age = GAS_TIME;
#ifdef NEEDS_PLACE_LATE
    age -= place.delay;
#endif
    float azimuth = bearing(place.at.y, place.at.x);
    vec2 outward = vec2(place.at.x, place.at.y) / rho;
    float out_way = dot(outward, vec2(place.way.x, place.way.y)) / rho;   // of ln(rho)
    float round_way = (outward.x * place.way.y - outward.y * place.way.x) / rho;
    float up_way = abs(place.way.z / height - y * out_way);
    float wide = (place.pixel / rho + abs(out_way)) / SOFT_RING + abs(round_way) * SOFT_CELLS_A_RADIAN;
    float clumps = gas_clumps(x, y, azimuth * 0.15915494309189533577, wide, up_way, age);
    MediumMatter matter = medium_nothing_there(gas_step(place, rho, inside, y, clumps * LAW_OPACITY / rho));
    matter.density = abs(y) < SOFT_HIGHEST ? gas_rim(inside) * exp(-0.5 * y * y) * clumps : 0.0;
    matter.over = rho;
    matter.heat = GAS_HEAT - 0.75 * 1.44269504088896341 * max(x - GAS_LOG_INNER, 0.0);
    matter.temperature = exp2(matter.heat);
    return medium_going_round(place, matter, gas_rate(1.0 / rho));
}

float medium_free(float r, float cosine) {
    float rho = r * sqrt(max(1.0 - cosine * cosine, 0.0));
    float above = (abs(r * cosine) - SOFT_HIGHEST * GAS_THICKNESS * rho) * GAS_SURFACE;
    return max(max(GAS_INNER - rho, rho - GAS_OUTER), above);
}
