// The picture where rays are interpolated: the sky alone, or the disc at one crossing and the sky behind it.
#include "effect/sampling.glsl"
#ifdef EFFECT_SKY
#include "object/celestial_sphere.glsl"
#endif
#ifdef EFFECT_SKY_PATTERN
#include "object/sky_pattern.glsl"
#endif
#ifdef INTERPOLATED_DISC
#include "object/disc_colour.glsl"
#include "path/disc"
#endif
#ifdef EFFECT_REFINE
#include "path/ray_way"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/pixel.glsl"
#include "stage/tile_varyings.glsl"

#ifdef INTERPOLATED_DISC
// With what lies behind it.
vec4 with_disc(Trace trace, vec2 at, vec4 behind) {
    TilePolynomial told = tile_disc();
    DiscCrossing crossing = crossing_told(trace, tile_told.x, polynomial_at(told, at), polynomial_right(told, at).xy * sampling_px(),
                                          polynomial_up(told, at).xy * sampling_px());
    vec4 disc = disc_colour(trace, crossing);
    disc = crossing.hit ? disc : vec4(0.0);
    vec4 light = vec4(disc.rgb + (disc.a < 1.0 ? (1.0 - disc.a) * behind.rgb : vec3(0.0)), behind.a);
#ifdef EFFECT_POINT_STARS
    light.a = 1.0 - disc.a;
#else
#ifdef EFFECT_REFINE
    light.a = told_way(crossing, tile_escapes(), tile_told.yzw);
#endif
#endif
    return light;
}
#else
vec4 with_disc(Trace trace, vec2 at, vec4 behind) { return behind; }
#endif

vec4 ray_light(vec2 pixel) {
    vec2 at = tile_place(pixel);
    TilePolynomial sky = tile_sky();
    Trace trace = trace_to_sky(pixel, polynomial_at(sky, at).xyz, polynomial_right(sky, at).xyz * sampling_px(), polynomial_up(sky, at).xyz * sampling_px());
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
    float rest = 1.0;
#else
#ifdef EFFECT_REFINE
    float rest = open_way(tile_escapes());
#else
    float rest = 0.0;
#endif
#endif
    return with_disc(trace, at, vec4(light, rest));
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
