// Solid bodies anywhere: along the ray in strides no longer than the distance to the nearest of them, then between two places
// on either side of its surface. march_value (written for the scene): below 0 inside of a body; march_room: how far along
// the ray the nearest is at least; march_object: which one.
//
// A body that the ray only grazes lies between two strides: where three values fall and rise again, the least between them is
// looked for too.

#define MARCH_GOLDEN 0.61803398875
#define MARCH_SEARCHES 9     // 0.618^9: a stride to 1/76
#define MARCH_REFINEMENTS 24
#define MARCH_FAR 16.0       // shortest strides: half the thinnest body

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

// The value with the body made half a pixel smaller where pixels are blurred (blur = 1): a pixel is covered in part between.
float march_value_at(Trace trace, RayPlace place, float phi, float blur) {
    return march_value(place) + (blur > 0.0 ? 0.5 * blur * place_pixel(trace, place, phi) : 0.0);
}

// Between `low` (outside) and `high` (inside): regula falsi, the end that stays halved (Illinois); every third step halves the
// interval, for values with a corner in them.
float march_refined(Trace trace, vec3 tangent, float blur, float low, float high, float low_value, float high_value) {
    float phi = high;
    int left = MARCH_REFINEMENTS;
    do {
        float width = high - low;
        float part = left % 3 == 0 ? 0.5 : clamp(low_value / max(low_value - high_value, 1.0e-30), 0.01, 0.99);
        phi = low + width * part;
        float value = march_value_at(trace, place_seen(trace, tangent, phi), phi, blur);
        if (value > 0.0) {
            low = phi;
            low_value = value;
            high_value *= 0.5;
        } else {
            high = phi;
            high_value = value;
            low_value *= 0.5;
        }
    } while (--left > 0 && high - low > 1.0e-7 * high);
    return high;
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

SolidHit march_hit(Trace trace, vec3 tangent, float phi_stop, float blur) {
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
    float nearest = 1.0;      // of what is met in part only: value in pixels, 0 ... 1
    float nearest_phi = 0.0;
    RayPlace place = place_seen(trace, tangent, 0.0);
    float phi = 0.0;
    float value = march_value_at(trace, place, phi, blur);
    float before_phi = 0.0;
    float before_value = value;
    int left = MARCH_MOST_STEPS;
    bool going = true;
    do {
#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
        // Far from every body the time need not be exact: strides without the delay map as long as they end there.
        bool far = true;
        do {
            float onward = min(phi + march_angle(place, march_length(place, reach)), phi_stop);
            RayPlace there = place_roughly(trace, tangent, onward, place);
            float distance = march_value_at(trace, there, onward, blur);
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
        float there = march_value_at(trace, place, next, blur);
        float a = before_phi;
        float b = next;
        float inside_phi = next;
        float inside_value = there;
        float outside_phi = phi;
        float outside_value = value;
        if (there > 0.0 && value < before_value && value <= there && value < march_graze(b - a, place)) {
            // A dip: the least in (a, b) by golden section.
            float x = b - MARCH_GOLDEN * (b - a);
            float y = a + MARCH_GOLDEN * (b - a);
            RayPlace at_x = place_seen(trace, tangent, x);
            RayPlace at_y = place_seen(trace, tangent, y);
            float fx = march_value_at(trace, at_x, x, blur);
            float fy = march_value_at(trace, at_y, y, blur);
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
                float value_there = march_value_at(trace, place_seen(trace, tangent, probe), probe, blur);
                if (lower) fx = value_there;
                else fy = value_there;
            } while (--searches > 0 && min(fx, fy) > 0.0);
            float dip = min(fx, fy);
            float dip_phi = fx < fy ? x : y;
            if (dip <= 0.0) {
                inside_phi = dip_phi;
                inside_value = dip;
                outside_phi = before_phi;
                outside_value = before_value;
            } else if (blur > 0.0) {
                float width = dip / max(blur * place_pixel(trace, place_seen(trace, tangent, dip_phi), dip_phi), 1.0e-20);
                if (width < nearest) {
                    nearest = width;
                    nearest_phi = dip_phi;
                }
            }
        }
        if (inside_value <= 0.0) {
            hit.phi = march_refined(trace, tangent, blur, outside_phi, inside_phi, outside_value, inside_value);
            hit.object = march_object(place_seen(trace, tangent, hit.phi));
            hit.covered = 1.0;
            going = false;
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
    if (hit.object == 0 && nearest < 1.0) {
        hit.phi = nearest_phi;
        hit.object = march_object(place_seen(trace, tangent, nearest_phi));
        hit.covered = 1.0 - nearest;
    }
    return hit;
}
