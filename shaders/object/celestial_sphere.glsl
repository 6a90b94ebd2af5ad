// The celestial sphere at infinity, a cube map in linear light.
//
// One trilinear fetch a pixel, so that no frame is dearer than another. The footprint's sides on the sky are the pixel's angle
// times d(phi)/d(alpha) along the ray's plane and sin(phi)/sin(alpha) across it; the level lies between the two: three fifths of
// the longer side at least (a trilinear tap spans two texels, so nothing is left out and points do not flicker), and their
// geometric mean where they are alike.
#include "effect/footprint.glsl"
#ifdef EFFECT_SKY_SHIFT
#ifdef EFFECT_ABERRATION
#include "effect/black_body.glsl"
#endif
#endif
#include "path/trace"
#include "shared/frame.glsl"

// log2 of the footprint, texels.
float sky_detail(Trace trace) {
    float along = abs(trace.stretch_along);
    float across = abs(trace.stretch_across);
    float wide = max(along, across);
    float side2 = max(0.36 * wide * wide, along * across) * trace.pixel_angle * trace.pixel_angle;
    vec3 size = abs(trace.sky);
    float texels = frame.sky.x / max(max(size.x, size.y), size.z);   // a cube face is denser towards its corners
    return 0.5 * log2(side2 * texels * texels);
}

float sky_level(Trace trace) { return footprint_level(sky_detail(trace), frame.sky.y); }

#ifdef EFFECT_SKY_SHIFT
// The sky's light as g changes it: that of a black body of its temperature. Without motion it is the same all over the sky.
vec3 sky_shift(Trace trace) {
#ifdef EFFECT_ABERRATION
    return frame.sky_light.xyz * seen_black_body(frame.sky_light.w, g_of(trace), frame.boost_colour.y);
#else
    return frame.sky_light.xyz;
#endif
}
#endif

#ifdef EFFECT_SKY
#ifdef EFFECT_FAR_SKY
uniform highp sampler2DArray sky_texture;

// The skies of both ends of a wormhole as layers of one texture: every ray fetches once, whichever sky it ends on. (Software drivers run
// both sides of a branch: two cube maps would be two fetches a pixel.) Faces as OpenGL's cube maps have them, with a border of the
// faces beside them, src/sky/sky.h.
vec3 celestial_sphere(Trace trace, float level) {
    vec3 d = trace.sky;
    vec3 size = abs(d);
    bool on_x = size.x >= max(size.y, size.z), on_y = !on_x && size.y >= size.z;
    float major = on_x ? d.x : on_y ? d.y : d.z;
    float facing = major < 0.0 ? -1.0 : 1.0;
    vec2 place = on_x ? vec2(-facing * d.z, -d.y) : on_y ? vec2(d.x, facing * d.z) : vec2(facing * d.x, -d.y);
    float layer = (on_x ? 0.0 : on_y ? 2.0 : 4.0) + (0.5 - 0.5 * facing);
    float other_side = trace.escapes ? 0.0 : 6.0;
    vec3 light = textureLod(sky_texture, vec3(place * (frame.sky.w / abs(major)) + 0.5, layer + other_side), level).rgb * frame.sky.z;
#ifdef EFFECT_SKY_SHIFT
    light *= trace.escapes ? sky_shift(trace) : vec3(1.0);
#endif
    return light;
}
#else
uniform samplerCube sky_texture;

vec3 celestial_sphere(Trace trace, float level) {
    vec3 light = textureLod(sky_texture, trace.sky, level).rgb * frame.sky.z;
#ifdef EFFECT_SKY_SHIFT
    light *= sky_shift(trace);
#endif
    return light;
}
#endif
#endif
