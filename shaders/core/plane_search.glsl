// Where a height over a plane that is known at both ends of a step, with its slope, is 0 between them. Heights and slopes: vec2 by the step's
// share s, 0 ... 1.

// Of the cubic with these at 0 and 1.
vec2 plane_cubic(vec2 from, vec2 to, float s) {
    float d = to.x - from.x;
    float third = from.y + to.y - 2.0 * d;
    float second = 3.0 * d - 2.0 * from.y - to.y;
    return vec2(from.x + s * (from.y + s * (second + s * third)), from.y + s * (2.0 * second + 3.0 * s * third));
}

// Where that cubic is lowest over the plane, if it is more than `on` beyond that and its ends are not; else 1.
float plane_dip(vec2 from, vec2 to, float on) {
    float side = from.x < 0.0 ? -1.0 : 1.0;
    float d = to.x - from.x;
    float third = from.y + to.y - 2.0 * d;
    float second = 3.0 * d - 2.0 * from.y - to.y;
    // of 3 third s^2 + 2 second s + from.y = 0 the root where it turns back
    float root = sqrt(max(second * second - 3.0 * third * from.y, 0.0));
    float s = -side * from.y / max(side * second + root, 1.0e-20);
    float value = from.x + s * (from.y + s * (second + s * third));
    bool dips = side * to.x > 0.0 && side * from.y < 0.0 && side * to.y > 0.0 && s > 0.0 && s < 1.0 && side * value < -on;
    return dips ? s : 1.0;
}

// By Newton's steps while they stay between what is known to be on this side and on the other.
struct PlaneSearch {
    float s;
    float low;
    float high;
};

// found: height and slope at s; begin: height at the step's start.
PlaneSearch plane_narrowed(PlaneSearch search, vec2 found, float begin) {
    search.low = found.x * begin > 0.0 ? search.s : search.low;
    search.high = found.x * begin > 0.0 ? search.high : search.s;
    float next = search.s - found.x / (abs(found.y) > 1.0e-30 ? found.y : 1.0e-30);
    search.s = next >= search.low && next <= search.high ? next : 0.5 * (search.low + search.high);
    return search;
}

// By the cubic, for a start.
PlaneSearch plane_search(vec2 from, vec2 to) {
    PlaneSearch search = PlaneSearch(0.5, 0.0, 1.0);
    search = plane_narrowed(search, plane_cubic(from, to, search.s), from.x);
    search = plane_narrowed(search, plane_cubic(from, to, search.s), from.x);
    search = plane_narrowed(search, plane_cubic(from, to, search.s), from.x);
    search = plane_narrowed(search, plane_cubic(from, to, search.s), from.x);
    search.low = 0.0;
    search.high = 1.0;
    return search;
}
