// Solid bodies anywhere: along the ray in steps no longer than the distance to the nearest of them, then between two places
// on either side of its surface. march_ask (written for the scene): a value, below 0 inside of a body, and the room, how far along the ray the
// nearest is at least; march_nearest: of the body that is nearest, its distance and by how much more its value changes; march_object: which one;
// march_round: the radius of the thinnest if all are round and of one size, or none; march_clear: how
// far the nearest is from a place, at least, of those that are not in a set, to which those nearer than `near` are added; and of all.
// march_list: of lists of bodies, those that a part of the way may touch; the others of a list are not asked there.
//
// A body that the ray only grazes lies between two steps: where three values fall and rise again, the least between them is
// looked for too, if march_grazes says that a body may be met there or cover a part of the pixel.
//
// MarchWay, way_place, way_value, way_pixel and way_pixel_least: the way that is marched along by a growing number (planar/march.glsl: the
// swept angle of an orbit; mino/march.glsl: the fraction of a step about a rotating hole), the place there, the value, and how wide a pixel
// is, on the mean and on its shorter side. MARCH_PROBES: how many probes are made behind a surface at most.
#include "generated/bodies_march"
#include "object/room.glsl"
#include "object/round.glsl"
#include "path/place"
#include "path/way"
#include "shared/frame.glsl"

#define MARCH_GOLDEN 0.61803398875
#define MARCH_SEARCHES 9     // 0.618^9: a step to 1/76
#define MARCH_REFINEMENTS 24
#define MARCH_EXACT 4.0e-7    // of the way: where a surface is met; four roundings

// A part of the way, between two samples or three, on which a ray enters a body (outside, inside: before and behind its surface) or comes
// close to one and leaves it again (a graze).
struct MarchSpan {
    bool enters;
    bool grazes;
    float outside;
    float outside_value;
    float inside;
    float inside_value;
};

MarchSpan march_span(float at, float value) {
    MarchSpan span;
    span.enters = false;
    span.grazes = false;
    span.outside = at;
    span.outside_value = value;
    span.inside = at;
    span.inside_value = value;
    return span;
}

// Where on a span, and how much of the pixel is covered there.
struct MarchContact {
    float at;
    RayPlace place;
    float covered;
    bool enters;
};

// How much of a pixel is covered whose ray comes `depth` deep into a body, below 0 by as much beside it; in pixels. thickness: the thinnest
// body's. Where a ray would come deeper than that the body is flat.
float march_cover(float depth, float thickness) {
    return depth > thickness ? 1.0 : clamp(0.5 + depth, 0.0, min(thickness, 1.0));
}

// Of a round body. Next to where the ray enters it its distance is a parabola, that of the ray from the middle has the square
// r^2/(1 + 2 depth/r).
float march_round_cover(float radius, float depth) {
    return round_cover(radius, depth > 0.0 ? radius * inversesqrt(1.0 + 2.0 * depth / radius) : radius - depth);
}

#define MARCH_THINNEST 32.0  // shortest steps: the thinnest body
#define MARCH_OWN_EDGES 1.5
#define MARCH_OWN_PX 2.0     // as far as bodies are looked for beside them (render/body_numbers.cpp)
#define MARCH_PROBE 4.0      // shortest steps
#define MARCH_ROUNDING 4.8e-7   // of r: what a second difference of distances may be by rounding alone

// What the search on a span asks for next.
#define SPAN_FIRST 0         // the golden section's two inner places
#define SPAN_SECOND 1
#define SPAN_DIP 2           // the next of them: the least value
#define SPAN_ROOT 3          // between outside and inside: the surface
#define SPAN_BEHIND 4        // a little behind it and before it
#define SPAN_BEFORE 5
#define SPAN_DONE 6

// The end of the span that stayed where it was in the last round.
#define SPAN_NEITHER 0
#define SPAN_OUTSIDE 1
#define SPAN_INSIDE 2

// What the search on a span has come to.
struct SpanSearch {
    int next;
    float at;             // where it looks next
    int left;             // looks
    MarchContact contact;
    float value_there;    // at contact.at
    float low;            // of the span that is left: the ends, and the values there
    float high;
    float low_value;
    float high_value;
    float x;              // the golden section's inner places, and the values there
    float y;
    float x_value;
    float y_value;
    int stays;
    float width;          // of the span, up to three rounds ago
    float probe;          // how far before and behind the surface, and the values there
    float value_before;
    float value_behind;
};

// For the surface, by regula falsi.
SpanSearch span_to_root(SpanSearch search) {
    search.left = MARCH_REFINEMENTS;
    search.at = search.low + (search.high - search.low) * clamp(search.low_value / max(search.low_value - search.high_value, 1.0e-30), 0.01, 0.99);
    search.next = SPAN_ROOT;
    return search;
}

SpanSearch span_start(MarchSpan span) {
    SpanSearch search;
    search.contact.at = span.inside;
    search.contact.covered = 0.0;
    search.contact.enters = span.enters;
    search.low = span.outside;
    search.high = span.inside;
    search.low_value = span.outside_value;
    search.high_value = span.inside_value;
    search.x = search.high - MARCH_GOLDEN * (search.high - search.low);
    search.y = search.low + MARCH_GOLDEN * (search.high - search.low);
    search.x_value = 0.0;
    search.y_value = 0.0;
    search.value_there = span.inside_value;
    search.value_before = 0.0;
    search.value_behind = 0.0;
    search.probe = 0.0;
    search.stays = SPAN_NEITHER;
    search.width = search.high - search.low;
    search.left = MARCH_SEARCHES;
    search.next = span.grazes ? SPAN_FIRST : SPAN_DONE;
    search.at = search.x;
    if (span.enters) search = span_to_root(search);
    return search;
}

// The least value found, or one below 0: then the surface is before it.
SpanSearch span_least(SpanSearch search, MarchSpan span) {
    search.contact.at = search.x_value < search.y_value ? search.x : search.y;
    search.value_there = min(search.x_value, search.y_value);
    search.next = SPAN_DONE;
    if (search.value_there <= 0.0) {
        search.contact.enters = true;
        search.low = span.outside;
        search.low_value = span.outside_value;
        search.high = search.contact.at;
        search.high_value = search.value_there;
        search.width = search.high - search.low;
        search = span_to_root(search);
    }
    return search;
}

// The golden section's part with the lesser of the inner values.
SpanSearch span_section(SpanSearch search) {
    if (search.x_value < search.y_value) {
        search.high = search.y;
        search.y = search.x;
        search.y_value = search.x_value;
        search.x = search.high - MARCH_GOLDEN * (search.high - search.low);
        search.at = search.x;
    } else {
        search.low = search.x;
        search.x = search.y;
        search.x_value = search.y_value;
        search.y = search.low + MARCH_GOLDEN * (search.high - search.low);
        search.at = search.y;
    }
    --search.left;
    search.next = SPAN_DIP;
    return search;
}

SpanSearch span_dip(SpanSearch search, MarchSpan span, float value) {
    if (search.next == SPAN_DIP && search.at == search.x) search.x_value = value;
    else search.y_value = value;
    if (search.left == 0 || min(search.x_value, search.y_value) <= 0.0) search = span_least(search, span);
    else search = span_section(search);
    return search;
}

// The end of the span that has moved, and its value; that of an end that stays counts for less.
SpanSearch span_narrowed(SpanSearch search, float value) {
    bool outside = value > 0.0;
    float share = 1.0 - value / (outside ? search.low_value : search.high_value);
    share = share > 0.0 ? share : 0.5;
    if (outside) {
        search.high_value *= search.stays == SPAN_INSIDE ? share : 1.0;
        search.stays = SPAN_INSIDE;
        search.low = search.at;
        search.low_value = value;
    } else {
        search.low_value *= search.stays == SPAN_OUTSIDE ? share : 1.0;
        search.stays = SPAN_OUTSIDE;
        search.high = search.at;
        search.high_value = value;
        search.value_there = value;
    }
    return search;
}

SpanSearch span_root(SpanSearch search, MarchWay way, RayPlace place, float value) {
    search = span_narrowed(search, value);
    --search.left;
    bool slow = search.left % 3 == 0 && search.high - search.low > 0.5 * search.width;   // not by half in three rounds
    search.width = search.left % 3 == 0 ? search.high - search.low : search.width;
    // A little beyond the root, away from the end that is closer: so that this one follows.
    float exact = 0.5 * MARCH_EXACT * abs(search.high);
    float at = search.low + (search.high - search.low) * (search.low_value / max(search.low_value - search.high_value, 1.0e-30));
    at += at - search.low < search.high - at ? exact : -exact;
    search.at = slow ? 0.5 * (search.low + search.high) : clamp(at, search.low + exact, max(search.high - exact, search.low + exact));
    if (search.left <= 0 || search.high - search.low <= 2.0 * exact) {
        search.contact.at = search.high;
        search.probe = min(MARCH_PROBE * frame.march.y / max(place_speed(place), 1.0e-20), way_left(way, search.high));
        search.at = search.high + search.probe;
        search.next = SPAN_BEHIND;
        search.left = MARCH_PROBES;
    }
    return search;
}

// Behind a surface, from where the ray has left a thin part of the body again, or a part close to the centre, less far.
SpanSearch span_behind(SpanSearch search, float value) {
    bool left = value > 0.0 && search.left > 1;
    search.value_behind = value;
    search.probe *= left ? 0.25 : 1.0;
    search.at = search.contact.at + (left ? search.probe : -search.probe);
    search.next = left ? SPAN_BEHIND : SPAN_BEFORE;
    --search.left;
    return search;
}

// By the value at search.at.
SpanSearch span_look(SpanSearch search, MarchWay way, MarchSpan span, RayPlace place, float value) {
    if (search.next == SPAN_FIRST) {
        search.x_value = value;
        search.at = search.y;
        search.next = SPAN_SECOND;
    } else if (search.next <= SPAN_DIP) {
        search = span_dip(search, span, value);
    } else if (search.next == SPAN_ROOT) {
        search = span_root(search, way, place, value);
    } else if (search.next == SPAN_BEHIND) {
        search = span_behind(search, value);
    } else {
        search.value_before = value;
        search.next = SPAN_DONE;
    }
    return search;
}

// What is met there, and how much of the pixel it covers.
MarchContact span_contact(SpanSearch search, MarchWay way, MarchSpan span, float blur) {
    MarchContact contact = search.contact;
    RayPlace place = way_place(way, contact.at);
    contact.place = place;
    float slope = 0.5 * (search.value_before - search.value_behind);
    float bend = search.value_before + search.value_behind - 2.0 * search.value_there;
    // Values of several bodies have several units: what is beside all of them is so by its distance.
    vec2 nearest = march_nearest(place, search.value_there);
    float depth = bend > max(1.0e-4 * abs(slope), MARCH_ROUNDING * place.r * nearest.y) ? 0.5 * slope * slope / bend : 1.0e30;
    depth = contact.enters ? depth / nearest.y : -nearest.x;
    float pixel = max(way_pixel(way, place, contact.at), 1.0e-20);
    float thickness = MARCH_THINNEST * frame.march.y / pixel;
    float cover = march_cover(depth / pixel, thickness);
    // Not in an arc next to a critical curve, where it is narrow one way only.
    if (march_round(thickness) * pixel < way_pixel_least(way, place, contact.at)) cover = march_round_cover(march_round(thickness), depth / pixel);
    // Next to where what is seen ends (object/unseen.glsl), pixels are wide, and a body's depth is not its own.
    bool own = place.r > MARCH_OWN_EDGES * frame.march_shell.w + MARCH_OWN_PX * pixel;
    if (contact.enters) contact.covered = blur > 0.0 && own ? cover : 1.0;
    else if (span.grazes && blur > 0.0) contact.covered = own ? cover : 0.0;
    return contact;
}

// The least value on a graze by golden section, the first below 0; the surface by regula falsi, where the value of an end that stays counts
// for less (Anderson and Bjorck 1973), and halves where that is slow; and how deep the ray will come by slope and curvature of the value
// along it. blur: bodies have soft edges. One value a round: software drivers run all of a loop for all of their rays.
MarchContact march_contact(MarchWay way, MarchSpan span, float blur) {
    SpanSearch search = span_start(span);
    do {
        RayPlace place = way_place(way, search.at);
        search = span_look(search, way, span, place, way_value(way, place));
    } while (search.next < SPAN_DONE);
    return span_contact(search, way, span, blur);
}

#ifdef MARCH_LISTS
#define MARCH_LIST 1.25   // the way for which bodies are listed, over that for which the list is of use: a step is 0.8 of the room
#endif

#ifndef EFFECT_SIDES
// How far what is known at a place holds: the ray's direction, and light's slowness.
float march_farthest(RayPlace place) {
#ifdef NEEDS_PLACE_LATE
    return min(0.4 * place.r, 2.0 * place.r / place_slowness(place));
#else
    return 0.4 * place.r;
#endif
}

#define MARCH_FARTHEST 0.99   // of r, in one step: it ends as exactly as its length is rounded

// How far on from far outside there is none for sure.
float march_outside(RayPlace place, float reach) { return min(place.r - 1.5 * reach, MARCH_FARTHEST * place.r); }

// How far to the next sample of a body, by the room that there is. Next to a horizon, where light is slow, a moving body could pass
// unnoticed between two samples.
float march_length(RayPlace place, float room, float reach) {
    if (place.r > 2.0 * reach) return march_outside(place, reach);
    float length = min(ROOM_PART * room, march_farthest(place));
#ifdef NEEDS_PLACE_LATE
    return max(length, frame.march.y / place_slowness(place));
#else
    return max(length, frame.march.y);
#endif
}
#endif
