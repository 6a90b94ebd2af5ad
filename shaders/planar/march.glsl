// Solid bodies along an orbit (object/march.glsl).
#include "core/trig.glsl"
#include "object/march.glsl"
#include "object/room.glsl"
#include "planar/place.glsl"
#include "object/solid_hit.glsl"
#include "shared/frame.glsl"

#define MARCH_LEAST 2.4e-7   // of the swept angle, a step: two roundings, or it would not go on
#define MARCH_DOUBT 8.0   // a moving body may be off by an eighth of its distance where the time is not exact: steps are 0.8 of that

// How far to the next sample.
float march_step(RayPlace place, float room, float reach) {
#ifdef EFFECT_SIDES
    return max(min(ROOM_PART * room, 0.4 * place.radius), frame.march.y);
#else
    return max(march_length(place, room, reach), ROOM_PART * (frame.march_shell.y - place.r));   // far from the innermost body
#endif
}

// Not on its way out beyond every body, nor on its way into the hole below them.
bool march_goes(bool escapes, RayPlace place, float reach) {
#ifdef EFFECT_SIDES
    float end_side = escapes ? 1.0 : -1.0;   // of the throat, where the ray ends
    return !(place.side == end_side && place.r_along > 0.0 && place.r > reach);
#else
    return place.r_along < 0.0 ? escapes || place.r > frame.march_shell.y : place.r < reach;
#endif
}

// What a search along an orbit has come to.
struct Search {
    MarchWay way;
    float phi_stop;
    float reach;         // radius about the centre beyond which no body lies
    RayPlace place;      // the last sample, at phi
    float phi;
    float value;
    float length;        // to the next one
#ifdef MARCH_LISTS
    float listed;        // the way on for which the list of bodies is of use
#endif
    float before_phi;    // the one before
    float before_value;
    int left;            // samples
    MarchSpan span;      // where something may be met
    bool going;          // there are more samples, or a span
    bool entered;        // hit is a body which the ray enters, though close to its silhouette
    SolidHit hit;
};

// Is there more to sample?
bool search_goes(Search search) {
    return search.left > 0 && search.phi < search.phi_stop && march_goes(search.way.trace.escapes, search.place, search.reach);
}

#ifdef MARCH_LISTS
// Lists the bodies on the next part of the way; where there are but a few they stay listed.
Search search_list(Search search) {
    RayPlace place = search.place;
    bool few = without_first(without_first(without_first(bodies_shown))) == uvec2(0u, 0u);
    float outside = march_outside(place, search.reach);
    float farthest = march_farthest(place);
    bool far = place.r > 2.0 * search.reach;
    search.listed = far ? outside : farthest;
    search.listed = few ? 1.0e30 : search.listed;
    if (few) bodies_near = bodies_shown;
    else march_list(place, MARCH_LIST * search.listed);
    search.length = march_step(place, march_ask(place).y, search.reach);
    return search;
}
#endif

// To the next span, or to the end.
Search search_samples(Search search) {
    bool ends = !search.going;
    bool stops = false;
    search.span = march_span(search.phi, search.value);
#ifdef MARCH_LISTS
    do {
    if (search.listed <= frame.march.y) search = search_list(search);
#endif
    do {
#ifdef MARCH_LISTS
        search.length = min(search.length, max(search.listed, ROOM_PART * (frame.march_shell.y - search.place.r)));
        search.listed -= search.length;
#endif
        float next = min(search.phi + max(place_part(search.place, search.length), MARCH_LEAST * search.phi), search.phi_stop);
#ifdef WAY_BETWEEN
        search.place = place_beside(search.way.trace, search.way.tangent, next, search.place, search.phi);
        float slack = MARCH_DOUBT * frame.march.w * search.place.doubt;   // bodies move meanwhile
#else
        search.place = place_of(search.way.trace, search.way.tangent, next);
        float slack = 0.0;
#endif
        vec2 asked = march_ask(search.place);
        float there = asked.x;
        float from_length = search.length;
        search.length = march_step(search.place, asked.y, search.reach);
        bool enters = search.value > 0.0 && there <= slack;
        bool grazes = there > slack && search.value > 0.0 && search.value < search.before_value && search.value <= there &&
                      march_grazes(from_length, search.value, place_pixel(search.way.trace, search.place, next));
        // In branches: see mino/walk.glsl.
        if (enters || grazes) {
            search.span.enters = enters;
            search.span.grazes = grazes;
            search.span.inside = next;
            search.span.inside_value = there;
            search.span.outside = enters ? search.phi : search.before_phi;
            search.span.outside_value = enters ? search.value : search.before_value;
            stops = true;
        }
        search.before_phi = search.phi;
        search.before_value = search.value;
        search.phi = next;
        search.value = there;
        --search.left;
#ifdef MARCH_LISTS
    } while (search_goes(search) && !stops && !ends && search.listed > frame.march.y);
#endif
    } while (search_goes(search) && !stops && !ends);
    search.going = !ends && search.left > 0 && (stops || search_goes(search));
    return search;
}

#ifdef WAY_BETWEEN
// The last sample with its time by the light-time table: whether the ray is in a body there is sure now.
Search search_sure(Search search) {
    search.place = place_seen(search.way.trace, search.way.tangent, search.phi);
    vec2 asked = march_ask(search.place);
    search.value = asked.x;
    search.length = march_step(search.place, asked.y, search.reach);
    search.way.known = search.place;
    search.way.known_phi = search.phi;
    bool inside = search.value <= 0.0;
    search.span.inside_value = search.value;
    search.span.enters = (search.span.enters || search.span.grazes) && inside;
    search.span.grazes = search.span.grazes && !inside;
    return search;
}
#endif

// What is on the span.
Search search_contact(Search search, float blur) {
    MarchContact contact = march_contact(search.way, search.span, blur);
    search.hit = hit_with_contact(search.hit, search.entered, contact.at, contact.place, contact.covered, contact.enters);
    search.entered = search.entered || contact.enters;
    search.going = search.going && !(contact.enters && contact.covered >= 1.0);
    return search;
}

// The part of the way on which the tile's bodies may be met.
#ifdef MARCH_LISTS
float march_begin(Trace trace) { return min(march_first, trace.phi_end); }
float march_end(float phi_stop) { return min(phi_stop, max(march_last, 1.0e-9)); }
#else
float march_begin(Trace trace) { return 0.0; }
float march_end(float phi_stop) { return phi_stop; }
#endif

SolidHit march_hit(Trace trace, vec3 tangent, float phi_stop, float blur) {
    Search search;
    search.way.trace = trace;
    search.way.tangent = tangent;
    search.phi_stop = march_end(phi_stop);
#ifdef EFFECT_SIDES
    search.reach = trace.escapes ? frame.march.x : frame.march.z;   // on the side where the ray ends
#else
    search.reach = frame.march.x;
#endif
    search.phi = march_begin(trace);
    search.place = place_of(trace, tangent, search.phi);
    search.left = MARCH_MOST_STEPS;
    search.going = true;
    search.entered = false;
    search.hit.object = 0;
    search.hit.phi = trace.phi_end;
    search.hit.covered = 0.0;
    search.hit.place = search.place;
    search.before_phi = search.phi;
    search.before_value = 0.0;   // none: nothing is left behind
#ifdef MARCH_LISTS
    search.listed = 0.0;
    bodies_near = bodies_shown;
#endif
    // From one place that may be on a body to the next: what is done there is outside of the loop of samples, for all rays at once.
#ifdef WAY_BETWEEN
    if (search.place.r > 2.0 * search.reach) search.phi = min(search.phi + place_part(search.place, march_outside(search.place, search.reach)), search.phi_stop);
    search.before_phi = search.phi;
    search.span = march_span(search.phi, 1.0e30);
    do {
        search = search_contact(search_sure(search), blur);
        search = search_samples(search);
    } while (search.going);
#else
    vec2 asked = march_ask(search.place);
    search.value = asked.x;
    search.length = march_step(search.place, asked.y, search.reach);
    do search = search_contact(search_samples(search), blur);
    while (search.going);
#endif
    if (search.hit.covered > 0.0) search.hit.object = march_object(search.hit.place);
    return search.hit;
}
