// The picture where rays are interpolated: the sky alone.
#include "effect/sampling.glsl"
#ifdef EFFECT_SKY
#include "object/celestial_sphere.glsl"
#endif
#ifdef EFFECT_SKY_PATTERN
#include "object/sky_pattern.glsl"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/pixel.glsl"
#include "stage/tile_varyings.glsl"

vec4 ray_light(vec2 pixel) {
    vec2 at = tile_place(pixel);
    TileSky sky = tile_sky();
    Trace trace = trace_to_sky(pixel, tile_sky_at(sky, at), tile_sky_right(sky, at) * sampling_px(), tile_sky_up(sky, at) * sampling_px());
    vec3 light = vec3(0.0);
#ifdef EFFECT_SKY
#ifdef NEEDS_SAMPLING
    light += celestial_sphere(trace, sky_fetches(trace));
#else
    float detail = tile_detail.x + at.x * tile_detail.y + at.y * (tile_detail.z + at.x * tile_detail.w);
    light += celestial_sphere(trace, SkyFetches(vec3(0.0), 1.0, footprint_level(detail, frame.sky.y)));
#endif
#endif
#ifdef EFFECT_SKY_PATTERN
    light += sky_pattern_light(trace);
#endif
    light = tile_escapes() ? light : vec3(0.0);
#ifdef EFFECT_POINT_STARS
    return vec4(light, 1.0);
#else
#ifdef EFFECT_REFINE
    return vec4(light, path_way(trace));
#else
    return vec4(light, 0.0);
#endif
#endif
}

out vec4 colour;

void main() {
#ifdef EFFECT_SAMPLES
    int number = sampling_first();
    int left = sampling_count();
    vec4 sum = vec4(0.0);
    do {   // tested at the end, see disc_cover
        sum += ray_light(fragment_pixel(number));
        ++number;
        --left;
    } while (left > 0);
    colour = fragment_colour(sum / float(sampling_count()));
#else
    colour = fragment_colour(ray_light(fragment_pixel(0)));
#endif
}
