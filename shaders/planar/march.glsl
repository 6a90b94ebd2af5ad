// Solid bodies along an orbit (object/march.glsl).
#include "core/trig.glsl"
#include "object/march.glsl"
#include "planar/place.glsl"
#include "object/solid_hit.glsl"
#include "shared/frame.glsl"

// Swept angle after `length` more along the ray, taken as straight.
float march_angle(RayPlace place, float length) {
#ifdef EFFECT_SIDES
    // dphi = q/R^2 along a way on which R grows by no more than the way itself.
    return length * place.radius / (place.speed * (place.radius + length));
#else
    float speed = inversesqrt(place.r_along * place.r_along + place.r * place.r);
    float y = length * place.r * speed;
    float x = place.r + length * place.r_along * speed;
    return arc_tangent2(max(y, 1.0e-30), x);
#endif
}

SolidHit march_hit(Trace trace, vec3 tangent, float phi_stop, float blur) {
    MarchWay way;
    way.trace = trace;
    way.tangent = tangent;
    SolidHit hit;
    hit.object = 0;
    hit.phi = trace.phi_end;
    hit.covered = 0.0;
#ifdef EFFECT_SIDES
    float end_side = trace.escapes ? 1.0 : -1.0;
    float reach = trace.escapes ? frame.march.x : frame.march.z;   // on the side where the ray ends
#else
    float reach = frame.march.x;
#endif
    float part = 0.0;         // of the pixel, of what is met in part only
    float part_phi = 0.0;
    bool entered = false;     // that is a body which the ray enters, though close to its silhouette
    RayPlace place = place_seen(trace, tangent, 0.0);
    float phi = 0.0;
    float value = march_value(place);
    float before_phi = 0.0;
    float before_value = value;
    int left = MARCH_MOST_STEPS;
    bool going = true;
    do {
#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
        // Far from every body the time need not be exact: steps without the delay map as long as they end there.
        bool far = true;
        do {
            float onward = min(phi + march_angle(place, march_length(place, reach)), phi_stop);
            RayPlace there = place_roughly(trace, tangent, onward, place);
            float distance = march_value(there);
            far = distance > MARCH_FAR * frame.march.y && onward < phi_stop && (there.r < reach || there.r_along < 0.0);
            if (far) {
                before_phi = phi;
                before_value = value;
                phi = onward;
                value = distance;
                place = there;
            }
        } while (far && --left > 0);
#endif
#endif
#ifdef EFFECT_SIDES
        float room = max(min(0.8 * march_room(place), 0.4 * place.radius), frame.march.y);
#else
        float room = march_length(place, reach);
#endif
        float next = min(phi + march_angle(place, room), phi_stop);
        place = place_seen(trace, tangent, next);
        float there = march_value(place);
        float a = before_phi;
        float b = next;
        float inside_phi = next;
        float inside_value = there;
        float outside_phi = phi;
        float outside_value = value;
        if (there > 0.0 && value > 0.0 && value < before_value && value <= there && value < march_graze(b - a, place)) {
            vec2 least = march_dip(way, a, b);
            float dip = least.y;
            float dip_phi = least.x;
            if (dip <= 0.0) {
                inside_phi = dip_phi;
                inside_value = dip;
                outside_phi = before_phi;
                outside_value = before_value;
            } else if (blur > 0.0) {
                float pixel = max(place_pixel(trace, place_seen(trace, tangent, dip_phi), dip_phi), 1.0e-20);
                float cover = march_cover(-dip / pixel, MARCH_THINNEST * frame.march.y / pixel);
                if (cover > part && !entered) {
                    part = cover;
                    part_phi = dip_phi;
                }
            }
        }
        if (inside_value <= 0.0 && outside_value > 0.0) {
            float entry = march_refined(way, outside_phi, inside_phi, outside_value, inside_value);
            float cover = blur > 0.0 ? march_entry_cover(way, entry) : 1.0;
            if (!entered) {
                part = cover;
                part_phi = entry;
            }
            entered = true;
            if (cover >= 1.0) {   // not on to the sky: all of it is what is entered first
                part = 1.0;
                going = false;
            }
        }
        before_phi = phi;
        before_value = value;
        phi = next;
        value = there;
#ifdef EFFECT_SIDES
        going = going && next < phi_stop && !(place.side == end_side && place.r_along > 0.0 && place.r > reach);
#else
        going = going && next < phi_stop && (place.r < reach || place.r_along < 0.0);
#endif
    } while (going && --left > 0);
    if (part > 0.0) {
        hit.phi = part_phi;
        hit.object = march_object(place_seen(trace, tangent, part_phi));
        hit.covered = part;
    }
    return hit;
}
