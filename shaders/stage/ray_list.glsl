// One ray of a list: it starts as the frame's camera, with numbers of its own (src/shadercore/listed_ray.h), and its crossings of the disc's
// plane are told one by one, wherever the disc is. Of these from number listed_first on, listed_most at most.
#ifdef EFFECT_DISC
#include "path/listed"
#endif
#include "path/start"
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/pixel_data.glsl"

#ifndef __cplusplus
uniform int listed_first;
uniform int listed_most;
#endif

#define LISTED_NEAREST 1.0e-30   // radii of a disc that is all of the plane
#define LISTED_FARTHEST 1.0e30

struct ListedData {
    PixelData end;
    float at;           // zeta at the angle that was asked for, 0 beyond the ray's end
    int count;
    bool more;          // there may be crossings behind
    vec4 crossing_0;    // x, y; climb (path/listed); 0
    vec4 crossing_1;
    vec4 crossing_2;
    vec4 crossing_3;
};

// start, radial, meridian, ray: RayNumbers.
ListedData listed_data(vec4 start, vec4 radial, vec4 meridian, vec4 ray) {
    ListedData data;
    data.at = 0.0;
    data.count = 0;
    data.more = false;
    data.crossing_0 = vec4(0.0, 0.0, 0.0, 0.0);
    data.crossing_1 = data.crossing_0;
    data.crossing_2 = data.crossing_0;
    data.crossing_3 = data.crossing_0;
    start_ray(start, radial, meridian, ray);
#ifdef EFFECT_DISC
    // While the ray is traced the disc is all of the plane, then the scene's own.
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    frame.disc_x.w = LISTED_NEAREST;
    frame.disc_y.w = LISTED_FARTHEST;
    frame.disc_surface.w = float(listed_first);
    Trace trace = trace_pixel(vec2(0.0, 0.0));
    bool there = listed_most > 0;
    for (int k = 0; k < 4 && there; ++k) {
        ListedCrossing crossing = listed_crossing(trace, k);
        there = crossing.there && k < listed_most;
        vec4 told = vec4(crossing.place.x, crossing.place.y, crossing.climb, crossing.along);
        if (there && k == 0) data.crossing_0 = told;
        if (there && k == 1) data.crossing_1 = told;
        if (there && k == 2) data.crossing_2 = told;
        if (there && k == 3) data.crossing_3 = told;
        data.count += there ? 1 : 0;
    }
    data.more = listed_more(trace) || (data.count > 0 && data.count == listed_most);
    if (meridian.w > 0.0) data.at = listed_at(trace, meridian.w);
    frame.disc_x.w = inner;
    frame.disc_y.w = outer;
    frame.disc_surface.w = listed_passed();
#else
    Trace trace = trace_pixel(vec2(0.0, 0.0));
#endif
    data.end = ray_data(trace);
#ifdef EFFECT_DISC
#ifdef NEEDS_PLACE
    // What lies behind a body is not met.
    int met = 0;
    if (data.count > 0 && data.crossing_0.w <= data.end.until) met = 1;
    if (data.count > 1 && data.crossing_1.w <= data.end.until) met = 2;
    if (data.count > 2 && data.crossing_2.w <= data.end.until) met = 3;
    if (data.count > 3 && data.crossing_3.w <= data.end.until) met = 4;
    data.more = data.more && met == data.count;
    data.count = met;
#endif
#endif
    return data;
}
