// Solid bodies anywhere: along the ray in strides no longer than the distance to the nearest of them, then between two places
// on either side of its surface. march_value (written for the scene): below 0 inside of a body; march_room: how far along
// the ray the nearest is at least; march_object: which one.
//
// A body that the ray only grazes lies between two strides: where three values fall and rise again, the least between them is
// looked for too.
//
// MarchWay, way_place, way_value and way_pixel: the way that is marched along by a growing number (object/plane_march.glsl: the swept angle of an orbit;
// object/spin_march.glsl: the fraction of a step about a spinning hole), the place there, the value, and how wide a pixel is.

#define MARCH_GOLDEN 0.61803398875
#define MARCH_SEARCHES 9     // 0.618^9: a stride to 1/76
#define MARCH_REFINEMENTS 24
#define MARCH_FAR 16.0       // shortest strides: half the thinnest body

// The value with the body made half a pixel smaller where pixels are blurred (blur = 1): a pixel is covered in part between.
float march_value_at(MarchWay way, RayPlace place, float at, float blur) {
    return way_value(way, place) + (blur > 0.0 ? 0.5 * blur * way_pixel(way, place, at) : 0.0);
}

// Between `low` (outside) and `high` (inside): regula falsi, the end that stays halved (Illinois); every third step halves the
// interval, for values with a corner in them.
float march_refined(MarchWay way, float blur, float low, float high, float low_value, float high_value) {
    float at = high;
    int left = MARCH_REFINEMENTS;
    do {
        float width = high - low;
        float part = left % 3 == 0 ? 0.5 : clamp(low_value / max(low_value - high_value, 1.0e-30), 0.01, 0.99);
        at = low + width * part;
        float value = march_value_at(way, way_place(way, at), at, blur);
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
vec2 march_dip(MarchWay way, float blur, float a, float b) {
    float x = b - MARCH_GOLDEN * (b - a);
    float y = a + MARCH_GOLDEN * (b - a);
    RayPlace at_x = way_place(way, x);
    RayPlace at_y = way_place(way, y);
    float fx = march_value_at(way, at_x, x, blur);
    float fy = march_value_at(way, at_y, y, blur);
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
        float value_there = march_value_at(way, way_place(way, probe), probe, blur);
        if (lower) fx = value_there;
        else fy = value_there;
    } while (--searches > 0 && min(fx, fy) > 0.0);
    return fx < fy ? vec2(x, fx) : vec2(y, fy);
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
