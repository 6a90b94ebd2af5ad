// A sky that is painted: the direction at infinity in its own axes, and the pixel's box there (object/celestial_sphere.glsl says what
// its sides are).
#include "core/pixel_sides.glsl"
#include "generated/materials"
#include "object/material.glsl"
#include "path/trace"
#include "shared/frame.glsl"

vec3 sky_pattern_axes(vec3 d) { return vec3(dot(frame.sky_pattern_x.xyz, d), dot(frame.sky_pattern_y.xyz, d), dot(frame.sky_pattern_z.xyz, d)); }

vec3 sky_pattern_light(Trace trace) {
    PixelSides sides = sky_sides(trace);
    Material material = Material(frame.sky_pattern_map, frame.sky_pattern_colour, frame.sky_pattern_second, 1.0);
    return sky_pattern(material, sky_pattern_axes(trace.sky), sky_pattern_axes(sides.along), sky_pattern_axes(sides.across));
}
