// Solid bodies along a ray about a rotating hole, step by step of its tracer (object/march.glsl).
#include "core/trig.glsl"
#include "object/march.glsl"
#include "object/solid_hit.glsl"
#include "mino/place.glsl"
#include "mino/step.glsl"
#include "shared/frame.glsl"

#define MARCH_LONGEST 0.5    // of a step; a dip between two steps is looked for on the second's polynomials, as far before its start
#define MARCH_BELOW 0.9      // of the way out to the least radius of a body

// How far to the next sample, as a part of the step: within the least radius of a body only the way out counts, not how light winds.
// fall: of zeta at the step's end. Outside of the photon orbits zeta falls faster and faster, within them ever slower: its rate is the
// largest at one end of what is left.
float march_step_length(RayPlace place, float length, float fall) {
    float zeta = 1.0 / place.r;
    float fastest = max(abs(dot(place.velocity, place.outward)) * zeta * zeta, fall);
    float below = MARCH_BELOW * (zeta - 1.0 / max(frame.march_shell.y, 1.0e-10)) / max(fastest, 1.0e-20);
    return min(max(place_part(place, length), below), MARCH_LONGEST);
}

// What a search has come to.
struct SolidSearch {
    bool going;
    bool meets;           // the step that was passed last may meet a body
    float pixel_angle;
    int left;             // looks
    float before;         // the last sample within a step, how long ago by Mino's time, and the value there
    float before_value;
    float length;         // of the way
    float psi;            // at the end of the step that was looked along
    float until;          // Mino's time there
    bool entered;         // hit is a body that the ray enters
    SolidHit hit;         // as far as it is known: covered > 0
};

#ifdef NEEDS_FOOTPRINT
#define SOLID_BLUR 1.0   // soft edges
#else
#define SOLID_BLUR 0.0
#endif

SolidSearch solid_search(bool ours, float pixel_angle) {
    SolidSearch search;
    search.going = ours;
    search.meets = false;
    search.pixel_angle = pixel_angle;
    search.left = MARCH_MOST_STEPS;
    search.before = 0.0;
    search.before_value = 0.0;   // none: a ray that begins in a body does not enter it
    search.length = 0.0;
    search.psi = 0.0;
    search.until = 0.0;
    search.entered = false;
    search.hit.object = 0;
    search.hit.phi = 1.0e30;
    search.hit.covered = 0.0;
    return search;
}

SolidSearch solid_met(SolidSearch search, MarchContact contact, float tau) {
    search.hit = hit_with_contact(search.hit, search.entered, tau, contact.place, contact.covered, contact.enters);
    search.entered = search.entered || contact.enters;
    search.going = search.going && !(contact.enters && contact.covered >= 1.0);
    return search;
}

// May a step come as close to the centre as a body does?
bool segment_reaches(SpinState from, SpinState to, float h) {
    float more = 0.25 * h * max(abs(from.v.w), abs(to.v.w));   // where zeta turns within it
    return (max(from.y.w, to.y.w) + more) * frame.march.x >= 1.0;
}

// What a search along one step has come to.
struct SegmentSearch {
    MarchWay way;
    RayPlace place;       // the last sample, at s
    float s;
    float value;
    float room;
    float before;         // the one before
    float before_value;
    MarchSpan span;       // where something may be met
    float fall;           // of zeta at the step's end, below 0 where the ray comes inward
    bool on;              // there is more of the step to be sampled
};

SegmentSearch segment_start(SpinRay ray, SpinSegment segment, SolidSearch search) {
    SegmentSearch at;
    at.way.ray = ray;
    at.way.segment = segment;
    at.way.pixel_angle = search.pixel_angle;
    at.s = 0.0;
    at.place = way_place(at.way, at.s);
    at.way.length = max(search.length, abs(1.0 / frame.shift.y - at.place.r));   // steps that no body is near to are left out
    vec2 asked = way_ask(at.way, at.place);
    at.value = asked.x;
    at.room = asked.y;
    at.before = max(1.0 - search.before / segment.h, -MARCH_LONGEST);
    at.before_value = search.before_value;
    at.fall = -spin_slope_at(segment.arc, 1.0).w;
    at.on = true;
    return at;
}

// Between the last sample, `length` on, and the next one.
SegmentSearch segment_span(SegmentSearch at, RayPlace there, float next, float value_there, float length) {
    if (at.value <= 0.0 ? at.before_value > 0.0 : value_there <= 0.0) {
        at.span.enters = true;
        at.span.inside = at.value <= 0.0 ? at.s : next;
        at.span.inside_value = at.value <= 0.0 ? at.value : value_there;
        at.span.outside = at.value <= 0.0 ? at.before : at.s;
        at.span.outside_value = at.value <= 0.0 ? at.before_value : at.value;
    }
    if (at.value > 0.0 && value_there > 0.0 && at.value < at.before_value && at.value <= value_there &&
        march_grazes(length, at.value, way_pixel(at.way, there, next))) {
        at.span.grazes = true;
        at.span.inside = next;
        at.span.outside = at.before;
        at.span.outside_value = at.before_value;
    }
    return at;
}

// To the next sample.
SegmentSearch segment_sample(SegmentSearch at) {
    float length = march_length(at.place, at.room, frame.march.x);
    float next = min(at.s + march_step_length(at.place, length, at.fall), 1.0);
    RayPlace there = way_place(at.way, next);
    vec3 chord = there.at - at.place.at;
    at.way.length += sqrt(dot(chord, chord));
    vec2 asked = way_ask(at.way, there);
    at = segment_span(at, there, next, asked.x, length);
    at.before = at.s;
    at.before_value = at.value;
    at.s = next;
    at.value = asked.x;
    at.room = asked.y;
    at.place = there;
    return at;
}

// Along a step that begins at Mino's time tau.
SolidSearch segment_search(SpinRay ray, SpinSegment segment, float tau, SolidSearch search) {
    SegmentSearch at = segment_start(ray, segment, search);
    do {   // from one place that may be on a body to the next, as planar/march.glsl
        at.span = march_span(at.s, at.value);
        do {
            at = segment_sample(at);
            // On its way out beyond every body; what it does in later steps they tell. On its way in close to the hole nothing is left.
            bool outward = dot(at.place.velocity, at.place.outward) > 0.0;
            search.going = search.going && (outward || at.place.r > frame.march_shell.z);
            at.on = search.going && at.s < 1.0 && (at.place.r < frame.march.x || !outward || at.fall < 0.0);
            search.left -= 1;
        } while (at.on && !at.span.enters && !at.span.grazes && search.left > 0);
        MarchContact contact = march_contact(at.way, at.span, SOLID_BLUR);
        if (at.span.enters || at.span.grazes)
            search = solid_met(search, contact, tau + contact.at * segment.h);
        at.on = at.on && search.going;
    } while (at.on && search.left > 0);
    bool whole = at.s >= 1.0;
    search.before = (1.0 - (whole ? at.before : at.s)) * segment.h;
    search.before_value = whole ? at.before_value : at.value;
    search.length = at.way.length;
    search.going = search.going && search.left > 0;
    return search;
}

// Does what is this large at the start, in the middle and at the end of a step stay above 0? Between them a parabola is off its chords by an
// eighth of the second difference; twice as much is left.
bool stays_above(float start, float middle, float end) {
    return min(min(start, middle), end) > 0.25 * abs(start - 2.0 * middle + end);
}

// May a body be on a step that comes as close as bodies do? Not where all of it is higher, or lower, than any: |z| > H where |n_z| > H zeta;
// nor where all of it is closer to the centre.
bool step_meets(SpinState from, SpinState to, float h) {
    vec4 middle = spin_at(spin_arc(from, to, h), 0.5);
    float high = frame.march_shell.x;
    float least = frame.march_shell.y;
    bool above = stays_above(from.y.z - high * from.y.w, middle.z - high * middle.w, to.y.z - high * to.y.w);
    bool below = stays_above(-from.y.z - high * from.y.w, -middle.z - high * middle.w, -to.y.z - high * to.y.w);
    bool closer = stays_above(least * from.y.w - 1.0, least * middle.w - 1.0, least * to.y.w - 1.0);
    return !above && !below && !closer;
}

#ifdef MARCH_LISTS
#define MARCH_ARC 1.1   // a half of a step over its chord, at most

// May a body be as near to the middle of the step as its ends are? Those that may be are listed.
bool step_touches(SpinRay ray, SpinState from, SpinState to, float h) {
    SpinSegment segment = spin_segment(ray, from, to, h);
    RayPlace middle = segment_place(ray, segment, 0.5);
    vec3 before = middle.at - segment_place(ray, segment, 0.0).at;
    vec3 behind = segment_place(ray, segment, 1.0).at - middle.at;
    float half_length = MARCH_ARC * sqrt(max(dot(before, before), dot(behind, behind)));
    march_list(middle, half_length < march_farthest(middle) ? MARCH_LIST * max(half_length, frame.march.y) : 1.0e30);
    return !(march_length(middle, march_ask(middle).y, frame.march.x) > max(half_length, frame.march.y));
}
#else
// Of few bodies: to ask costs more than the searches that it saves.
bool step_touches(SpinRay ray, SpinState from, SpinState to, float h) { return true; }
#endif

// The length of the way behind a step that no body is on, by its chord.
float length_behind(SolidSearch search, SpinState from, SpinState to) {
    float r = 1.0 / max(from.y.w, 1.0e-10);
    float r_to = 1.0 / max(to.y.w, 1.0e-10);
    vec3 chord = r_to * vec3(to.y.x, to.y.y, to.y.z) - r * vec3(from.y.x, from.y.y, from.y.z);
    return max(search.length, abs(1.0 / frame.shift.y - r)) + sqrt(dot(chord, chord));
}

// Past a step: may it meet a body?
SolidSearch search_passes(SolidSearch search, SpinState from, SpinState to, float h) {
    search.meets = false;
    if (segment_reaches(from, to, h)) {
        search.meets = search.going && step_meets(from, to, h);
        if (!search.meets) search.length = length_behind(search, from, to);
    }
    return search;
}

SolidSearch step_search(SpinRay ray, SpinStep at, SolidSearch search) {
    if (at.begun > search.until) {   // no body is near to the steps between
        search.before = 0.0;
        search.before_value = 1.0e30;
    }
    search.before += at.h;
    search.until = at.begun + at.h;
    SpinSegment segment = spin_segment(ray, at.from, at.to, at.h);
    search = segment_search(ray, segment, at.begun, search);
    search.psi = segment_psi(ray, segment, at.to);
    return search;
}

SolidHit solid_found(SolidSearch search) {
    SolidHit hit = search.hit;
    if (hit.covered > 0.0) hit.object = march_object(hit.place);
    return hit;
}
