// The celestial sphere at infinity, faces of a cube in linear light.
//
// The footprint's sides on the sky are the pixel's angle times d(phi)/d(alpha) along the ray's plane and sin(phi)/sin(alpha) across it.
// A picture of one ray a pixel takes one trilinear fetch, so that no frame is dearer than another. Its level lies between the two sides:
// three fifths of the longer one at least (a trilinear tap spans two texels, so nothing is left out and points do not flicker), and their
// geometric mean where they are alike. A picture whose edges are drawn with more rays takes several fetches along the longer side.
#include "effect/footprint.glsl"
#ifdef EFFECT_SKY_SHIFT
#ifdef EFFECT_ABERRATION
#include "effect/black_body.glsl"
#endif
#endif
#include "effect/sampling.glsl"
#include "object/sky_face.glsl"
#include "path/trace"
#include "shared/frame.glsl"

// Texels per radian: a cube face is denser towards its corners.
float sky_texels(Trace trace) {
    vec3 size = abs(trace.sky);
    return frame.sky.x / max(max(size.x, size.y), size.z);
}

// log2 of what a fetch has to span, texels, for sides in texels.
float sky_span(float along, float across) {
    float wide = max(along, across);
    return footprint_detail(max(0.36 * wide * wide, along * across));
}

float sky_detail(Trace trace) {
    float scale = trace.pixel_angle * sky_texels(trace);
    return sky_span(abs(trace.stretch_along) * scale, abs(trace.stretch_across) * scale);
}

// Where the sky is fetched: at the ray's direction + longer * t, for t at the middles of so many equal parts of -1/2 ... 1/2.
struct SkyFetches {
    vec3 longer;   // side of the footprint, rad
    float count;
    float level;
};

#ifdef NEEDS_SAMPLING
// The parallelogram of the pixel's sides is taken as the ellipse that they are conjugate to.
SkyFetches sky_fetches(Trace trace) {
    PixelSides sides = sky_sides(trace);
    float aa = dot(sides.along, sides.along);
    float bb = dot(sides.across, sides.across);
    float ab = dot(sides.along, sides.across);
    vec3 area = cross(sides.along, sides.across);
    float apart = sqrt((aa - bb) * (aa - bb) + 4.0 * ab * ab);
    float turn = (aa - bb) / max(apart, 1.0e-30);   // cosine of twice the angle from `along` to the longer side
    float c = sqrt(max(0.5 + 0.5 * turn, 0.0));
    float s = sqrt(max(0.5 - 0.5 * turn, 0.0));
    float texels = sky_texels(trace);
    float longer = max(sqrt(0.5 * (aa + bb + apart)) * texels, 1.0e-12);
    float shorter = min(sqrt(dot(area, area)) * texels * texels / longer, longer);
    SkyFetches fetches;
    fetches.longer = c * sides.along + (ab < 0.0 ? -s : s) * sides.across;
    bool seen = trace.escapes;   // others would take as long, for nothing
#ifdef EFFECT_FAR_SKY
    seen = true;
#endif
#ifdef NEEDS_SKY_OF_EVERY_RAY
    seen = true;
#endif
    fetches.count = clamp(ceil(longer / max(shorter, 1.0)), 1.0, seen ? sampling_fetches() : 1.0);
    fetches.level = footprint_level(sky_span(longer / fetches.count, shorter), frame.sky.y);
    return fetches;
}
#else
SkyFetches sky_fetches(Trace trace) { return SkyFetches(vec3(0.0), 1.0, footprint_level(sky_detail(trace), frame.sky.y)); }
#endif

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
uniform highp sampler2DArray sky_texture;

// Through a wormhole every ray fetches once, whichever sky it ends on. (Software drivers run both sides of a branch: two textures would be
// two fetches a pixel.)
vec3 celestial_sphere(Trace trace, SkyFetches fetches) {
    SkyFace face = sky_face(trace.sky);
#ifdef EFFECT_FAR_SKY
    face.layer += trace.escapes ? 0.0 : 6.0;
#endif
    vec3 light = vec3(0.0);
    float part = 0.5;
    do {   // tested at the end, see disc_cover
        vec3 at = trace.sky + fetches.longer * (part / fetches.count - 0.5);
        light += textureLod(sky_texture, sky_face_place(face, at), fetches.level).rgb;
        part += 1.0;
    } while (part < fetches.count);
    light *= frame.sky.z / fetches.count;
#ifdef EFFECT_SKY_SHIFT
#ifdef EFFECT_FAR_SKY
    light *= trace.escapes ? sky_shift(trace) : vec3(1.0);
#else
    light *= sky_shift(trace);
#endif
#endif
    return light;
}
#endif
