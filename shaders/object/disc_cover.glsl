// What the disc is covered with: its image or texture, filtered by the footprint.
#include "shared/frame.glsl"
#ifdef EFFECT_DISC_IMAGE
#include "effect/footprint.glsl"
#endif
#ifdef EFFECT_DISC_PATTERN
#include "generated/materials"
#include "object/material.glsl"
#endif

#ifdef EFFECT_DISC_IMAGE
uniform sampler2D disc_texture;

vec4 disc_texel(vec2 place, float level) {
    vec2 turned = vec2(frame.disc_map.x * place.x + frame.disc_map.y * place.y,
                       frame.disc_map.x * place.y - frame.disc_map.y * place.x);
    return textureLod(disc_texture, vec2(0.5 + turned.x, 0.5 - turned.y), level);
}

// The image, filtered by the footprint's sides a and b.
vec4 disc_filtered(vec2 middle, vec2 a, vec2 b) {
    float texels = frame.disc_map.z;
    float aa = dot(a, a);
    float bb = dot(b, b);
    vec2 wide = aa > bb ? a : b;
    float longer2 = max(aa, bb) * texels * texels;                     // sides of the footprint in texels, squared
    float area = abs(a.x * b.y - a.y * b.x) * texels * texels;
    // One tap, or two along the longer side of a footprint that is long and more than one texel wide.
    bool two = longer2 > 2.0 && longer2 > 2.25 * area;
    float side2 = two ? max(0.25 * longer2, area) : longer2;
    float level = footprint_level(footprint_detail(side2), frame.disc_map.w);
    vec2 step = two ? 0.5 * wide : vec2(0.0);
    vec2 place = middle - 0.5 * step;
    vec4 texel = vec4(0.0);
    int left = two ? 2 : 1;
    do {   // tested at the end: software rasterisers run a loop's body once more than a test at its head lets through
        texel += disc_texel(place, level);
        place += step;
    } while (--left > 0);
    return texel * (two ? 0.5 : 1.0);
}
#endif

// Of image or texture at a place, with the pixel's sides a and b there.
vec4 disc_cover(vec2 place, vec2 a, vec2 b) {
#ifdef EFFECT_DISC_IMAGE
    return disc_filtered(place, a, b);
#endif
#ifdef EFFECT_DISC_PATTERN
    Material material = Material(frame.disc_material_map, frame.disc_material_colour, frame.disc_material_second, frame.disc_y.w);
    return vec4(disc_material_pattern(material, vec3(place, 0.0), vec3(a, 0.0), vec3(b, 0.0)), 1.0);
#endif
    return vec4(1.0);
}
