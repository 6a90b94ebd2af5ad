// The light of a pixel's rays, as the picture has it.
#include "effect/sampling.glsl"
#include "stage/pixel.glsl"
#ifdef MATTER_LATTICE
#include "stage/lattice_light.glsl"
#else
#ifdef TILES_OF_FULL_DISC
#include "stage/full_disc_light.glsl"
#else
#include "stage/ray_light.glsl"
#endif
vec4 pixel_light(vec2 pixel) { return ray_light(pixel); }
#endif
#ifdef TILES_WITH_BODIES
#include "core/tile_bodies.glsl"
#include "generated/bodies_march"

#ifdef BY_COMPUTE
vec4 tile_set;
#else
flat in highp vec4 tile_set;   // stage/tile.vert
#endif
#endif

vec4 traced_pixel() {
#ifdef TILES_WITH_BODIES
#ifdef MARCH_LISTS
    TileBodies bodies = tile_bodies_of(tile_set);
    bodies_shown = bodies.set;
    march_first = bodies.first;
    march_last = bodies.last;
#endif
#endif
#ifdef EFFECT_SAMPLES
    int number = sampling_first();
    int left = sampling_count();
    vec4 sum = vec4(0.0);
    do {   // tested at the end, see disc_cover
        sum += fragment_light(pixel_light(fragment_pixel(number)));
        ++number;
        --left;
    } while (left > 0);
    return fragment_colour(sum / float(sampling_count()));
#else
    return fragment_colour(fragment_light(pixel_light(fragment_pixel(0))));
#endif
}
