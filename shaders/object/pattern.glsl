// What covers something, a body, the disc or the sky: this text is written once for each, with BODY its name. At a place on it: how a
// pixel lies there, the texture averaged over it.
#include "effect/body_mapping.glsl"
#include "object/material.glsl"
#include "shared/frame.glsl"
#ifdef TEXTURE_PATTERN
#include "effect/pattern.glsl"
#endif
#ifdef TEXTURE_NOISE
#include "effect/grain.glsl"
#endif
#ifdef TEXTURE_FORMULA
#include "effect/expression.glsl"
#endif
#ifdef TEXTURE_IMAGE
#include "effect/footprint.glsl"

vec3 BODY_image(vec2 uv, vec2 a, vec2 b) {
    vec2 texels = vec2(textureSize(IMAGE, 0));
    vec2 wide = a * texels;
    vec2 high = b * texels;
    float aa = dot(wide, wide);
    float bb = dot(high, high);
    float side2 = max(0.36 * max(aa, bb), abs(wide.x * high.y - wide.y * high.x));
    float level = footprint_level(footprint_detail(side2), 16.0);
    return textureLod(IMAGE, uv, level).rgb;
}
#endif
#ifdef TEXTURE_FORMULA
float BODY_blend(vec2 uv, vec3 at) {
    float u = uv.x;
    float v = uv.y;
    float x = at.x;
    float y = at.y;
    float z = at.z;
BODY_STATEMENTS
    return clamp(value, 0.0, 1.0);
}
#endif

vec2 BODY_uv(Material material, vec3 at) {
#ifdef MAPPING_PLANE
    vec3 turned = mapping_turned(at, material.map.xy) * (0.5 / material.size);
    return vec2(0.5 + turned.x, 0.5 - turned.y);
#endif
#ifdef MAPPING_POLAR
    return mapping_polar(mapping_turned(at, material.map.xy), frame.disc_x.w, frame.disc_y.w);
#endif
#ifdef MAPPING_INSIDE
    return mapping_inside(at);
#endif
#ifdef MAPPING_EQUIRECTANGULAR
    return mapping_equirectangular(mapping_turned(at, material.map.xy));
#endif
#ifdef MAPPING_BAND
    return mapping_band(mapping_turned(at, material.map.xy), material.second.w);
#endif
#ifdef MAPPING_CAPS
    return mapping_caps(mapping_turned(at, material.map.xy));
#endif
#ifdef MAPPING_CUBE
    return mapping_cube(mapping_turned(at, material.map.xy));
#endif
}

#ifdef MAPPING_OUTSIDE
float BODY_width(vec3 at, vec3 along, vec3 across) {
    float share = inversesqrt(max(dot(at, at), 1.0e-36));
    vec3 a = along * share;
    vec3 b = across * share;
    vec3 area = cross(a, b);
    return sqrt(dot(area, area) / max(max(dot(a, a), dot(b, b)), 1.0e-36));
}
#else
float BODY_width(vec3 at, vec3 along, vec3 across) { return 0.0; }
#endif

// How far (u, v) moves with the place: a side of the pixel's box. least: the box's lesser width, in radii.
vec2 BODY_step(Material material, vec3 at, vec3 side, vec2 uv, float least) {
#ifdef MAPPING_POLAR
    return mapping_polar_step(at, side, frame.disc_y.w - frame.disc_x.w);
#endif
#ifdef MAPPING_INSIDE
    return mapping_inside_step(at, side);
#endif
#ifdef MAPPING_OUTSIDE
    return mapping_step(BODY_uv(material, at + side), uv, least);
#endif
}

#ifdef TEXTURE_FORMULA
// (u, v) at a corner of the pixel's box; uv: as far as it may be drawn from the middle's.
vec2 BODY_corner(Material material, vec3 spot, vec2 uv) {
#ifdef MAPPING_OUTSIDE
    return uv;
#else
    return BODY_uv(material, spot);
#endif
}
#endif

// Light of the texture at a place, about the body's middle; along, across: the pixel's box there.
vec3 BODY_pattern(Material material, vec3 at, vec3 along, vec3 across) {
    vec3 first = material.colour.rgb;
    vec3 second = material.second.rgb;
    vec2 uv = BODY_uv(material, at);
    float least = BODY_width(at, along, across);
    vec2 a = BODY_step(material, at, along, uv, least);
    vec2 b = BODY_step(material, at, across, uv, least);
    vec2 cells = material.map.zw;
    vec2 wide = (abs(a) + abs(b)) * cells;
    vec3 light = first;
#ifdef TEXTURE_CHECKER
    light = mix(second, first, pattern_checker(uv * cells, wide));
#endif
#ifdef TEXTURE_GRID
    light = mix(second, first, pattern_grid(uv * cells, wide));
#endif
#ifdef TEXTURE_STRIPES
    light = mix(second, first, pattern_stripes(uv * cells, wide));
#endif
#ifdef TEXTURE_NOISE
    float grains = cells.x / material.size;
    vec3 grain = mapping_turned(at, material.map.xy) * grains;
    light = mix(second, first, grain_noise(grain, grains * max(length(along), length(across))));
#endif
#ifdef TEXTURE_FORMULA
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {   // four places of the pixel's box
        vec2 corner = vec2((i & 1) == 0 ? -0.25 : 0.25, i < 2 ? -0.25 : 0.25);
        vec3 spot = at + corner.x * along + corner.y * across;
        sum += BODY_blend(BODY_corner(material, spot, uv + corner.x * a + corner.y * b), spot);
    }
    light = mix(second, first, 0.25 * sum);
#endif
#ifdef TEXTURE_IMAGE
    light = first * BODY_image(uv, a, b);
#endif
#ifdef MAPPING_BAND
    light = mix(light, second, clamp((abs(uv.y - 0.5) - 0.5) / max(abs(a.y) + abs(b.y), 1.0e-6) + 0.5, 0.0, 1.0));
#endif
    return light;
}
