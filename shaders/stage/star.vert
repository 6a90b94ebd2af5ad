// One image of one star: where in the picture it is, and the light that its pixels share.
#include "effect/black_body.glsl"
#ifndef EFFECT_SPIN
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#include "object/star_image.glsl"
#endif
#include "shared/frame.glsl"

#ifdef EFFECT_SPIN
layout(location = 0) in vec3 star_place;   // of an image (src/render/star_mesh.h): px from the picture's middle, y up; g
#else
layout(location = 0) in vec3 star_place;   // world axes, unit
#endif
layout(location = 1) in vec2 star_make;    // log2 of flux over a black body's brightness at its temperature, of an image over the sky in a pixel too; log2 of that, K
flat out vec3 star_peak;
flat out vec2 star_middle;                 // px

void main() {
#ifdef EFFECT_SPIN
    star_peak = seen_black_body(star_make.y, star_place.z, -star_make.x) * frame.point_stars.x;
    vec2 pixel = vec2(star_place.x, star_place.y);
    float ahead = 1.0;
#else
    StarImage image = image_of_star(star_place);
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
    float ahead = dot(d, frame.ray_0.xyz);
    vec2 at = vec2(dot(d, frame.ray_x.xyz), dot(d, frame.ray_y.xyz));
#else
    // Along the axes through the hole: keeps its digits at a hole of a few microradians.
    float ahead = dot(d, frame.polar_0.xyz);
    vec2 at = vec2(dot(d, frame.polar_x.xyz), dot(d, frame.polar_y.xyz));
#endif
    vec3 light = seen_black_body(star_make.y, g, -star_make.x);
    vec2 pixel = at / (max(ahead, 1.0e-6) * frame.image.z * frame.image.z);
    // A pixel spans image.z^2 cos^3 of solid angle; the spread squeezed by aberration.
    float pixels = frame.image.z * frame.image.z * ahead * ahead * ahead;
    star_peak = light * (image.spread * squeeze * squeeze / max(pixels, 1.0e-30) * frame.point_stars.x);
#endif
    star_middle = pixel + 0.5 * frame.image.xy;
    float bright = max(max(star_peak.r, star_peak.g), star_peak.b) * frame.image.w;
    float reach2 = log2(bright * frame.point_stars.z) * frame.point_stars.y;
    bool seen_here = ahead > 0.0 && reach2 > 0.0;
    gl_PointSize = 2.0 * ceil(sqrt(max(reach2, 0.0))) + 1.0;
    gl_Position = seen_here ? vec4(pixel / (0.5 * frame.image.xy + frame.point_stars.w), 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
