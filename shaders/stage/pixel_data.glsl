// What is known of a pixel's ray before any colour: written by raydata.frag, compared by the tests, printed by `trace`.
#ifdef EFFECT_STAR
#include "core/trig.glsl"
#endif
#ifdef NEEDS_PLACE
#include "generated/bodies_hit"
#endif
#ifdef EFFECT_DISC
#include "path/disc"
#endif
#ifdef NEEDS_LIGHT_TIMES
#include "path/delay"
#endif
#include "core/view.glsl"
#include "path/trace"
#include "shared/frame.glsl"

struct PixelData {
    float fate;     // 0 escaped, 1 captured, 2 other side, 3 none, 4 hit (scene/ray.h)
    vec3 sky;       // unit direction on the celestial sphere; zero unless the ray ends on a sky; of a star, the place hit
    float g;        // frequency in the camera over frequency at infinity; 0 unless escaped
    float delay;    // T of an escaped ray; from where an opaque object is hit, the light time; 0 without light times
    float angle;    // swept from the camera to the end
    float hit;      // number of the first object met, 0 for none
    vec3 place;     // of that meeting: x, y, z in r_s; of methods that count their steps, where nothing is met, x is their number
    float along;    // where that is on the ray, by what tells the order of places; 0 for none
    float steps;    // that the tracer took; 0 of planar rays
#ifdef NEEDS_PLACE
    float until;    // by what tells the order of places, where a body ends the ray; none: beyond all
#endif
};

// Of a pixel that shows nothing.
PixelData no_ray() {
    PixelData data;
    data.fate = 3.0;
    data.sky = vec3(0.0, 0.0, 0.0);
    data.g = 0.0;
    data.delay = 0.0;
    data.angle = 0.0;
    data.hit = 0.0;
    data.place = vec3(0.0, 0.0, 0.0);
    data.along = 0.0;
    data.steps = 0.0;
#ifdef NEEDS_PLACE
    data.until = 0.0;
#endif
    return data;
}

// Of the end alone.
PixelData data_of_end(Trace trace) {
    PixelData data = no_ray();
    data.fate = trace.escapes ? 0.0 : frame.shift.w;
    data.angle = path_angle(trace);
    data.steps = path_steps(trace);
    return data;
}

#ifdef NEEDS_PLACE
bool data_hides(PixelData data, float along) { return along > data.until; }
#else
bool data_hides(PixelData data, float along) { return false; }
#endif

#ifdef EFFECT_DISC
#ifdef NEEDS_LIGHT_TIMES
float data_disc_delay(Trace trace, DiscCrossing crossing) { return disc_delay(trace, crossing) + 1.0 / frame.shift.y; }
#else
float data_disc_delay(Trace trace, DiscCrossing crossing) { return 0.0; }
#endif

PixelData data_of_crossings(PixelData data, Trace trace) {
    for (DiscWalk walk = disc_walk(trace); walk.more && data.hit == 0.0; walk = disc_next(trace, walk)) {
        DiscCrossing crossing = disc_walk_crossing(trace, walk);
        if (data_hides(data, crossing.phi)) break;
        if (crossing.hit) {
            data.hit = 1.0;
            data.place = crossing_place_in_world(crossing);
            data.along = crossing.phi;
            if (frame.disc_surface.x >= 1.0) {   // opaque: the ray ends here
                data.fate = 4.0;
                data.angle = swept_angle(crossing.phi);
                data.delay = data_disc_delay(trace, crossing);
            }
        }
    }
    return data;
}
#else
PixelData data_of_crossings(PixelData data, Trace trace) { return data; }
#endif

#ifdef NEEDS_PLACE
#ifdef NEEDS_LIGHT_TIMES
float data_solid_delay(Trace trace, SolidHit solid) { return place_light_time(trace, solid.place, solid.phi) + 1.0 / frame.shift.y; }
#else
float data_solid_delay(Trace trace, SolidHit solid) { return 0.0; }
#endif

PixelData data_of_objects(PixelData data, Trace trace) {
    SolidHit solid = solid_hit(trace, 0.0);
    data.until = solid.phi;
    if (solid.object != 0) data.angle = swept_angle(solid.phi);
    data = data_of_crossings(data, trace);
    if (solid.object != 0 && data.fate != 4.0) {
        data.fate = 4.0;
        data.delay = data_solid_delay(trace, solid);
        if (data.hit == 0.0) {
            data.hit = float(solid.object);
            data.place = solid.place.at;
            data.along = solid.phi;
        }
    }
    return data;
}
#else
PixelData data_of_objects(PixelData data, Trace trace) { return data_of_crossings(data, trace); }
#endif

#ifdef EFFECT_STAR
PixelData data_of_star(PixelData data, Trace trace) {
    if (data.fate == 4.0 && data.hit == 0.0) {
        vec3 place = normalize(trace.sky);
        float longitude = arc_tangent2(abs(place.y), place.x);
        data.hit = 6.0;
        data.place = vec3(place.y < 0.0 ? -longitude : longitude,
                          1.57079632679489661923 - arc_tangent2(sqrt(place.x * place.x + place.y * place.y), place.z), 0.0);
    }
    return data;
}
#else
PixelData data_of_star(PixelData data, Trace trace) { return data; }
#endif

PixelData ray_data(Trace trace) {
    PixelData data = data_of_star(data_of_objects(data_of_end(trace), trace), trace);
#ifdef EFFECT_ZOOM
    data.angle += ring_part(data.angle, frame.ring.x);
#endif
    bool sky = data.fate == 0.0 || data.fate == 2.0;
#ifdef NEEDS_LIGHT_TIMES
    if (data.fate == 0.0) data.delay = sky_delay(trace);
#endif
    data.sky = sky ? normalize(trace.sky) : vec3(0.0, 0.0, 0.0);
    data.g = sky ? g_of(trace) : 0.0;
#ifdef METHOD_COUNTS
    if (data.hit == 0.0) data.place.x = data.steps;
#endif
    return data;
}

PixelData pixel_data(vec2 pixel) {
#ifdef BLOCK_PROJECTION
    if (frame.projection.x > 0.0 && beyond_view(pixel) > 0.0) return no_ray();
#endif
    return ray_data(trace_pixel(pixel));
}
