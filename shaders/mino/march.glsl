// Solid bodies along a ray about a rotating hole, step by step of its tracer (object/march.glsl).
#include "core/trig.glsl"
#include "object/march.glsl"
#include "object/solid_hit.glsl"
#include "mino/place.glsl"
#include "shared/frame.glsl"

#define MARCH_LONGEST 0.5    // of a step; a dip between two steps is looked for on the second's polynomials, as far before its start

// The part of a step that is `length` more along the ray, taken as straight.
float march_part(RayPlace place, float length) {
    float speed = max(place_speed(place), 1.0e-20);
    float outward = dot(place.velocity, place.outward) / speed;
    vec3 across = place.velocity - (outward * speed) * place.outward;
    float round = max(sqrt(dot(across, across)) / speed, 1.0e-7);
    return arc_tangent2(length * round, max(place.r + length * outward, 1.0e-6)) * place.r / (speed * round);
}

// How far to the next look, as a part of the step: within the least radius of a body only the way out counts, not how light winds.
float march_step_length(RayPlace place, float reach) {
    float outward = abs(dot(place.velocity, place.outward));
    float below = 0.9 * (frame.march.z - place.r) / max(outward, 1.0e-20);
    return min(max(march_part(place, march_length(place, reach)), below), MARCH_LONGEST);
}

// What a search has come to.
struct SolidSearch {
    bool going;
    int left;             // looks
    float before;         // the last look within a step, how long ago by Mino's time, and the value there
    float before_value;
    float length;         // of the way
    float psi;            // at the end of the step that was looked along
    bool entered;         // hit is a body that the ray enters
    SolidHit hit;         // as far as it is known: covered > 0
};

SolidSearch solid_search() {
    SolidSearch search;
    search.going = true;
    search.left = MARCH_MOST_STEPS;
    search.before = 0.0;
    search.before_value = 1.0e30;
    search.length = 0.0;
    search.psi = 0.0;
    search.entered = false;
    search.hit.object = 0;
    search.hit.phi = 1.0e30;
    search.hit.covered = 0.0;
    return search;
}

// What the ray enters first, or else comes closest to. Where it enters something behind that as a whole it does not go on to the sky.
SolidSearch solid_met(SolidSearch search, RayPlace place, float tau, float cover, bool entered) {
    if (!search.entered && (entered || cover > search.hit.covered)) {
        search.hit.place = place;
        search.hit.phi = tau;
        search.hit.covered = cover;
    }
    search.entered = search.entered || entered;
    if (entered && cover >= 1.0) {
        search.hit.covered = 1.0;
        search.going = false;
    }
    return search;
}

// May a step come as close to the centre as a body does?
bool leg_reaches(SpinState from, SpinState to, float h) {
    float more = 0.25 * h * max(abs(from.v.w), abs(to.v.w));   // where zeta turns within it
    return (max(from.y.w, to.y.w) + more) * frame.march.x >= 1.0;
}

// Along a step that begins at Mino's time tau.
SolidSearch leg_search(SpinRay ray, SpinLeg leg, float tau, float pixel_angle, float blur, SolidSearch search) {
    float reach = frame.march.x;
    MarchWay way;
    way.ray = ray;
    way.leg = leg;
    way.pixel_angle = pixel_angle;
    float s = 0.0;
    RayPlace place = way_place(way, s);
    way.length = max(search.length, abs(1.0 / frame.shift.y - place.r));   // steps that no body is near to are left out
    float value = way_value(way, place);
    float before = max(1.0 - search.before / leg.h, -MARCH_LONGEST);
    float before_value = search.before_value;
    bool grows_to = spin_slope_at(leg.arc, 1.0).w > 0.0;
    bool on = true;
    do {
        float next = min(s + march_step_length(place, reach), 1.0);
        RayPlace there = way_place(way, next);
        vec3 chord = there.at - place.at;
        way.length += sqrt(dot(chord, chord));
        float value_there = way_value(way, there);
        float inside = value <= 0.0 ? s : next;
        float inside_value = value <= 0.0 ? value : value_there;
        float outside = value <= 0.0 ? before : s;
        float outside_value = value <= 0.0 ? before_value : value;
        if (value > 0.0 && value_there > 0.0 && value < before_value && value <= value_there && value < march_graze(next - before, there)) {
            vec2 dip = march_dip(way, before, next);
            if (dip.y <= 0.0) {
                inside = dip.x;
                inside_value = dip.y;
                outside = before;
                outside_value = before_value;
            } else if (blur > 0.0) {
                float pixel = max(way_pixel(way, there, dip.x), 1.0e-20);
                search = solid_met(search, way_place(way, dip.x), tau + dip.x * leg.h, march_cover(-dip.y / pixel, MARCH_THINNEST * frame.march.y / pixel), false);
            }
        }
        if (inside_value <= 0.0 && outside_value > 0.0) {
            float at = march_refined(way, outside, inside, outside_value, inside_value);
            search = solid_met(search, way_place(way, at), tau + at * leg.h, blur > 0.0 ? march_entry_cover(way, at) : 1.0, true);
        }
        before = s;
        before_value = value;
        s = next;
        value = value_there;
        place = there;
        // On its way out beyond every body; what it does in later steps they tell. On its way in close to the hole nothing is left.
        bool outward = dot(place.velocity, place.outward) > 0.0;
        search.going = search.going && (outward || place.r > frame.march.w);
        on = search.going && next < 1.0 && (place.r < reach || !outward || grows_to);
        search.left -= 1;
    } while (on && search.left > 0);
    bool whole = s >= 1.0;
    search.before = (1.0 - (whole ? before : s)) * leg.h;
    search.before_value = whole ? before_value : value;
    search.length = way.length;
    search.going = search.going && search.left > 0;
    return search;
}

// Along the step between two states that begins at Mino's time tau, if it comes near to a body.
SolidSearch step_search(SpinRay ray, SpinState from, SpinState to, float h, float tau, float pixel_angle, float blur, SolidSearch search) {
    search.before += h;
    search.psi = to.psi;
    if (search.going && leg_reaches(from, to, h)) {
        SpinLeg leg = spin_leg(ray, from, to, h);
        search = leg_search(ray, leg, tau, pixel_angle, blur, search);
        search.psi = leg_psi(ray, leg, to);
    }
    return search;
}

SolidHit solid_found(SolidSearch search) {
    SolidHit hit = search.hit;
    if (hit.covered > 0.0) hit.object = march_object(hit.place);
    return hit;
}
