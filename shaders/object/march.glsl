// Solid bodies anywhere: along the ray in steps no longer than the distance to the nearest of them, then between two places
// on either side of its surface. march_value (written for the scene): below 0 inside of a body; march_room: how far along
// the ray the nearest is at least; march_object: which one.
//
// A body that the ray only grazes lies between two steps: where three values fall and rise again, the least between them is
// looked for too.
//
// MarchWay, way_place, way_value and way_pixel: the way that is marched along by a growing number (planar/march.glsl: the swept angle of an orbit;
// mino/march.glsl: the fraction of a step about a rotating hole), the place there, the value, and how wide a pixel is.
#include "generated/bodies_march"
#include "path/place"
#include "path/way"
#include "shared/frame.glsl"

#define MARCH_GOLDEN 0.61803398875
#define MARCH_SEARCHES 9     // 0.618^9: a step to 1/76
#define MARCH_REFINEMENTS 24
#define MARCH_FAR 16.0       // shortest steps: half the thinnest body

// Between `low` (outside) and `high` (inside): regula falsi, the end that stays halved (Illinois); every third step halves the
// interval, for values with a corner in them.
float march_refined(MarchWay way, float low, float high, float low_value, float high_value) {
    float at = high;
    int left = MARCH_REFINEMENTS;
    do {
        float width = high - low;
        float part = left % 3 == 0 ? 0.5 : clamp(low_value / max(low_value - high_value, 1.0e-30), 0.01, 0.99);
        at = low + width * part;
        float value = way_value(way, way_place(way, at));
        if (value > 0.0) {
            low = at;
            low_value = value;
            high_value *= 0.5;
        } else {
            high = at;
            high_value = value;
            low_value *= 0.5;
        }
    } while (--left > 0 && high - low > 1.0e-7 * abs(high));
    return high;
}

// The least in (a, b) by golden section: where, and the value; the first below 0.
vec2 march_dip(MarchWay way, float a, float b) {
    float x = b - MARCH_GOLDEN * (b - a);
    float y = a + MARCH_GOLDEN * (b - a);
    float fx = way_value(way, way_place(way, x));
    float fy = way_value(way, way_place(way, y));
    int searches = MARCH_SEARCHES;
    do {
        bool lower = fx < fy;
        if (lower) {
            b = y;
            y = x;
            fy = fx;
            x = b - MARCH_GOLDEN * (b - a);
        } else {
            a = x;
            x = y;
            fx = fy;
            y = a + MARCH_GOLDEN * (b - a);
        }
        float probe = lower ? x : y;
        float value_there = way_value(way, way_place(way, probe));
        if (lower) fx = value_there;
        else fy = value_there;
    } while (--searches > 0 && min(fx, fy) > 0.0);
    return fx < fy ? vec2(x, fx) : vec2(y, fy);
}

// How much of a pixel is covered whose ray comes `depth` deep into a body, below 0 by as much beside it; in pixels. thickness: the thinnest
// body's. Where a ray would come deeper than that the body is flat.
float march_cover(float depth, float thickness) {
    return depth > thickness ? 1.0 : clamp(0.5 + depth, 0.0, min(thickness, 1.0));
}

#define MARCH_THINNEST 32.0  // shortest steps: the thinnest body
#define MARCH_PROBE 4.0      // shortest steps

// The same of a ray that enters a body there: how deep it will come by slope and curvature of the value along it.
float march_entry_cover(MarchWay way, float at) {
    RayPlace place = way_place(way, at);
    float pixel = max(way_pixel(way, place, at), 1.0e-20);
    float probe = min(MARCH_PROBE * frame.march.y / max(place_speed(place), 1.0e-20), way_left(way, at));
    float before = way_value(way, way_place(way, at - probe));
    float after = way_value(way, way_place(way, at + probe));
    float slope = 0.5 * (before - after);
    float bend = before + after - 2.0 * way_value(way, place);
    float depth = bend > 1.0e-4 * abs(slope) ? 0.5 * slope * slope / bend : 1.0e30;
    return march_cover(depth / pixel, MARCH_THINNEST * frame.march.y / pixel);
}

#ifndef EFFECT_SIDES
// How far to the next look at a body. Where light is slow, next to a horizon, what moves would pass unseen between two looks at places.
float march_length(RayPlace place, float reach) {
    if (place.r > 2.0 * reach) return place.r - 1.5 * reach;
    float room = min(0.8 * march_room(place), 0.4 * place.r);
#ifdef NEEDS_PLACE_LATE
    float slowness = place_slowness(place);
    return max(min(room, 2.0 * place.r / slowness), frame.march.y / slowness);
#else
    return max(room, frame.march.y);
#endif
}
#endif
