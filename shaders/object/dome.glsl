// A sky that is painted: the direction at infinity in its own axes, and the pixel's box there (object/celestial_sphere.glsl says what
// its sides are).
#include "generated/coats"
#include "path/trace"
#include "shared/frame.glsl"

vec3 dome_axes(vec3 d) { return vec3(dot(frame.dome_x.xyz, d), dot(frame.dome_y.xyz, d), dot(frame.dome_z.xyz, d)); }

vec3 dome_light(Trace trace) {
    SkySides sides = sky_sides(trace);
    return dome_paint(dome_axes(trace.sky), dome_axes(sides.along), dome_axes(sides.across));
}
