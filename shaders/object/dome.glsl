// A sky that is painted: the direction at infinity in its own axes, and the pixel's box there (object/celestial_sphere.glsl says what
// its sides are). Boxes wider than the sphere are all of it.
#include "generated/coats"
#include "object/tracer.glsl"
#include "shared/frame.glsl"

#define DOME_WIDEST 4.0

vec3 dome_axes(vec3 d) { return vec3(dot(frame.dome_x.xyz, d), dot(frame.dome_y.xyz, d), dot(frame.dome_z.xyz, d)); }

vec3 dome_light(Trace trace) {
#ifdef EFFECT_SPIN
    return dome_paint(dome_axes(trace.sky), dome_axes(trace.sky_right), dome_axes(trace.sky_up));
#else
    vec3 across = crossed_direction(trace) / max(trace.s, 1.0e-30);   // 0 for an exactly radial ray: no box
    vec3 along = cross(across, trace.sky);
    float high = clamp(trace.stretch_along * trace.pixel_angle, -DOME_WIDEST, DOME_WIDEST);
    float wide = clamp(trace.stretch_across * trace.pixel_angle, -DOME_WIDEST, DOME_WIDEST);
    return dome_paint(dome_axes(trace.sky), dome_axes(along) * high, dome_axes(across) * wide);
#endif
}
