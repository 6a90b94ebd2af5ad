// One image of one star (planar/star_image.glsl): where in the picture it is, and its light.
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#include "core/view_place.glsl"
#include "effect/black_body.glsl"
#include "effect/star_point.glsl"
#include "planar/star_image.glsl"
#include "shared/frame.glsl"

// place: on the sky, world axes, unit. make: log2 of flux over a black body's brightness at its temperature, log2 of that, K.
StarPoint star_point(vec3 place, vec2 make) {
    StarPoint point;
    StarImage image = image_of_star(place);
    vec3 d = image.direction;
    float g = frame.radial.w / (frame.shift.x + frame.shift.z * d.z);
    float squeeze = 1.0;
#ifdef EFFECT_ABERRATION
    vec3 motion = vec3(frame.boost.x, frame.boost.y, frame.boost.z);
    d = d.x * frame.meridian.xyz + d.y * frame.transverse.xyz + d.z * frame.radial.xyz;
    g *= aberrate(d, motion, 1.0, frame.boost_colour.x).doppler;
    Aberration seen = aberrate(d, motion, 1.0 / frame.boost.w, 1.0);   // back to the camera
    d = seen.direction;
    squeeze = seen.squeeze;
    vec3 view = vec3(vec2(dot(d, frame.ray_x.xyz), dot(d, frame.ray_y.xyz)) / frame.image.z, dot(d, frame.ray_0.xyz));
#else
    // Along the axes through the hole: keeps its digits at a hole of a few microradians.
    vec3 view = vec3(vec2(dot(d, frame.polar_x.xyz), dot(d, frame.polar_y.xyz)) / frame.image.z, dot(d, frame.polar_0.xyz));
#endif
    vec3 light = seen_black_body(make.y, g, -make.x);
    ViewPlace place_seen = view_place(view);
    point.pixel = place_seen.at;
    point.seen = place_seen.seen;
    point.peak = light * (image.spread * squeeze * squeeze / max(place_seen.pixels, 1.0e-30) * frame.point_stars.x);
    return point;
}
