// The march through matter, as every kind of path has it: spans of a ray between two of its places, with samples on the cubic between them.
#include "generated/medium"
#include "generated/medium_law"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#ifdef EFFECT_MEDIUM_BANDS
#include "medium/bands.glsl"
#endif
#ifdef MEDIUM_STOKES
#include "medium/stokes_rows.glsl"
#endif
#include "shared/frame.glsl"

#define MEDIUM_MOST_SPANS 8192   // src/plan/medium.cpp
#define MEDIUM_SAMPLES 4      // of a span
#define MEDIUM_SHORTEST 0.015625   // of a span, a sample whose length follows the matter
#define MEDIUM_LONGEST 0.5    // of a ray's step, or rad, a span
#define MEDIUM_FARTHEST 0.99  // of r, in one jump

uniform int medium_longer;    // 1: samples and spans are twice as long, of pictures in motion (render/light_lattice.h)

float medium_stretch() { return medium_longer > 0 ? 2.0 * frame.medium_bound.z : frame.medium_bound.z; }
float medium_longest() { return medium_longer > 0 ? 2.0 * MEDIUM_LONGEST : MEDIUM_LONGEST; }

struct MediumSum {
    vec3 light;
    float through;   // what of the light behind comes through it
    float step;      // length of the next sample, r_s
#ifdef EFFECT_MEDIUM_BANDS
    vec3 bands;      // the same of each of several frequencies, whose most is `through`
#endif
#ifdef MEDIUM_MEAN
    vec2 weight;     // of all that was gone along: light that reaches the camera, and what of the light behind is hidden
    vec2 moment;     // and the same times where on the ray it is
#endif
#ifdef MEDIUM_STOKES
    StokesSight stokes;
#endif
};

MediumSum medium_nothing() {
    MediumSum sum;
    sum.light = vec3(0.0);
    sum.through = 1.0;
    sum.step = frame.medium_bound.y;
#ifdef EFFECT_MEDIUM_BANDS
    sum.bands = vec3(1.0);
#endif
#ifdef MEDIUM_MEAN
    sum.weight = vec2(0.0);
    sum.moment = vec2(0.0);
#endif
#ifdef MEDIUM_STOKES
    sum.stokes = stokes_nothing();
#endif
    return sum;
}

struct MediumSpan {
    vec3 from;           // places at its ends, r_s, world axes
    vec3 to;
    vec3 from_slope;     // and how they change, by the span
    vec3 to_slope;
    float way;           // of the affine parameter; over Sigma = r^2 + a^2 cos^2(theta) unless by_length
    bool by_length;      // straight rays are followed by their length
    float energy;        // MediumPlace's
    float momentum;
    float pixel_angle;
    vec3 camera;         // its place
    vec2 turns;          // azimuth that both ends have more (MediumPlace::turn)
#ifdef NEEDS_PLACE_LATE
    vec2 delays;         // of light from both ends
#endif
#ifdef MEDIUM_MEAN
    vec2 along;          // where on the ray both ends are
#endif
#ifdef MEDIUM_STOKES
    vec2 phase;          // screen_phase() of the ray
#endif
};

// A sample more, `way` of the affine parameter long, along which source and absorption are taken as even. Where way is 0 nothing that was
// found is used: far out it is no number. along: where on the ray it is.
#ifdef EFFECT_MEDIUM_BANDS
MediumSum medium_add(MediumSum sum, MediumBands found, float way, float along) {
    vec3 depth = way > 0.0 ? found.absorption * way : vec3(0.0);
    vec3 dims = exp(-depth);
    vec3 thick = (1.0 - dims) / max(depth, vec3(1.0e-2));
    vec3 thin = 1.0 - depth * (0.5 - depth * (1.0 / 6.0));   // as below
    vec3 share = sum.bands * mix(thick, thin, vec3(lessThan(depth, vec3(1.0e-2))));
    vec3 seen = way > 0.0 ? way * bands_colour(found, share) : vec3(0.0);
    sum.light += seen;
#ifdef MEDIUM_MEAN
    vec2 weight = vec2(seen.r + seen.g + seen.b, dot(share * depth, vec3(1.0 / 3.0)));
    sum.weight += weight;
    sum.moment += along * weight;
#endif
    sum.bands *= dims;
    sum.through = max(max(sum.bands.r, sum.bands.g), sum.bands.b);
    return sum;
}
#else
MediumSum medium_add(MediumSum sum, MediumLight found, float way, float along) {
    float depth = found.absorption * way;
    vec3 light = found.emission * way;
    depth = way > 0.0 ? depth : 0.0;
    light = way > 0.0 ? light : vec3(0.0);
    float dims = exp(-depth);
    float thick = (1.0 - dims) / max(depth, 1.0e-2);
    float thin = 1.0 - depth * (0.5 - depth * (1.0 / 6.0));   // of (1 - exp(-x))/x
    float share = depth < 1.0e-2 ? thin : thick;
    vec3 seen = (sum.through * share) * light;
    sum.light += seen;
#ifdef MEDIUM_MEAN
    vec2 weight = vec2(seen.r + seen.g + seen.b, sum.through * share * depth);
    sum.weight += weight;
    sum.moment += along * weight;
#endif
    sum.through *= dims;
    return sum;
}
#endif

#ifdef MEDIUM_STOKES
// Light and what of the light behind comes through are then those of rows (medium/stokes_rows.glsl), for which sum.through tells where to end.
MediumSum medium_add_stokes(MediumSum sum, MediumLight found, MediumStokes stokes, float way) {
    float depth = way > 0.0 ? found.absorption * way : 0.0;
    vec3 light = way > 0.0 ? found.emission * way : vec3(0.0);
    vec3 turned = way > 0.0 ? clamp(stokes.turned * way, -STOKES_MOST_TURN, STOKES_MOST_TURN) : vec3(0.0);
    vec3 emitted = way > 0.0 ? stokes.emitted : vec3(0.0);
    vec3 absorbed = way > 0.0 ? depth * stokes.absorbed : vec3(0.0);
    sum.stokes = stokes_through(sum.stokes, light, depth, emitted, absorbed, turned);
    sum.through *= exp(min(length(absorbed) - depth, 0.0));   // of what is least absorbed
    return sum;
}
#endif

// What the row of the picture gets, and the share of it that light behind has.
#ifdef MEDIUM_STOKES
vec3 medium_seen_light(MediumSum sum) { return sum.stokes.light; }
float medium_left(MediumSum sum) { return sum.through > 0.0 ? max(sum.stokes.row.x, 0.0) : 0.0; }
#else
vec3 medium_seen_light(MediumSum sum) { return sum.light; }
float medium_left(MediumSum sum) { return sum.through; }
#endif

// At the end of a march, which stops where nearly nothing comes through.
float medium_rest(float through) { return through > frame.medium_colour.w ? through : 0.0; }

// How far to go on where matter is `free` away at least, and was `before` a jump of `length` ago: along rays that run beside it farther than
// `free`, as long as they are nearly straight. From far away in several jumps: one would end as exactly as its length is rounded.
float medium_jump(float free, float before, float length, float r) {
    float closer = (before - free) / max(length, 1.0e-20);
    return min(max(free, min(0.9 * free / max(closer, 0.5), 0.15 * r)), MEDIUM_FARTHEST * r);
}

// The next sample's length behind a way to where there may be matter; comes: from outside of it.
#ifdef MEDIUM_OWN_STEPS
float medium_step(bool comes, float step) { return comes ? frame.medium_bound.y : step; }
#else
float medium_step(bool comes, float step) { return step; }
#endif

#ifdef MEDIUM_MEAN
MediumSpan medium_on_ray(MediumSpan span, float from, float to) {
    span.along = vec2(from, to);
    return span;
}
#else
MediumSpan medium_on_ray(MediumSpan span, float from, float to) { return span; }
#endif

// How much of a span the next sample is, where `left` of it is left. Some matter has samples as long as it
// allows where they begin, in whole numbers:
// the last one is no shorter than most.
float medium_share(float wanted, float left) {
#ifdef MEDIUM_OWN_STEPS
    return left / max(floor(left / max(wanted, MEDIUM_SHORTEST) + 0.5), 1.0);
#else
    return 1.0 / float(MEDIUM_SAMPLES);
#endif
}

// empty: nothing is there.
MediumSum medium_along(MediumSpan span, MediumSum sum, bool empty) {
    vec3 c1 = span.from_slope;
    vec3 d = span.to - span.from;
    vec3 c2 = 3.0 * d - 2.0 * c1 - span.to_slope;
    vec3 c3 = c1 + span.to_slope - 2.0 * d;
    float first = empty ? 1.0 - MEDIUM_SHORTEST : 0.0;
    vec3 begin = span.from;
    do {
        float wanted = max(sum.step, frame.medium_bound.y);
        vec3 speed = c1 + first * (2.0 * c2 + 3.0 * first * c3);
        float share = medium_share(wanted * inversesqrt(max(dot(speed, speed), 1.0e-20)), 1.0 - first);
        float s = first + 0.5 * share;
        float last = first + share;
        vec3 end = span.from + last * (c1 + last * (c2 + last * c3));
        MediumPlace at;
        at.at = span.from + s * (c1 + s * (c2 + s * c3));
        at.r = sqrt(max(dot(at.at, at.at), 1.0e-12));
        at.cosine = at.at.z / at.r;
        at.energy = span.energy;
        at.momentum = span.momentum;
        at.begin = begin;
        at.way = end - begin;
        vec3 away = at.at - span.camera;
        at.turn = mix(span.turns.x, span.turns.y, s);
        at.pixel = span.pixel_angle * sqrt(dot(away, away));
#ifdef NEEDS_PLACE_LATE
        at.delay = mix(span.delays.x, span.delays.y, s);
#endif
        float az = frame.medium_hole.x * at.cosine;
        float sigma = span.by_length ? 1.0 : at.r * at.r + az * az;
        float way = sigma * span.way * share;
        begin = end;
        first = last;
        MediumMatter matter = medium_matter(at);
#ifdef EFFECT_MEDIUM_BANDS
        MediumBands found = medium_bands(at, matter);
#else
        MediumLight found = medium_light(at, matter);
#endif
        bool there = !empty && at.r > frame.medium_hole.w && at.r < frame.medium_bound.x;
        float along = 0.0;
#ifdef MEDIUM_MEAN
        along = mix(span.along.x, span.along.y, s);
#endif
#ifdef MEDIUM_STOKES
        sum = medium_add_stokes(sum, found, medium_stokes(at, matter, span.phase), there ? way : 0.0);
#else
        sum = medium_add(sum, found, there ? way : 0.0, along);
#endif
        sum.step = there ? found.step * medium_stretch() * (2.0 - sum.through) : sum.step;
#ifdef MEDIUM_OWN_STEPS
        first = sum.through > frame.medium_colour.w ? first : 1.0;
#endif
    } while (first < 1.0 - 0.5 * MEDIUM_SHORTEST);
    return sum;
}
