// What a tile of the picture may show, as its texel has it: the set of bodies (core/bits.glsl), or neither body nor disc. Bodies are looked for in larger
// tiles first, whose texels are sets alone (tile_scale).
#include "core/view.glsl"
#include "generated/tiles"
#include "shared/frame.glsl"
#include "stage/tile_kind.glsl"
#ifdef TILES_OF_BODIES
#include "core/tile_bodies.glsl"
#include "path/tile"

uniform highp sampler2D tile_texture;   // of the first pass

TileBodies tile_among(ivec2 tile) {
    ivec2 first = tile / FIRST_TILES;
    TileBodies among = tile_bodies_of(texelFetch(tile_texture, first, 0));
    if (tile_scale > 1) among = tile_whole_way(TILE_ALL);
    return among;
}
#endif
#ifdef TILES_OF_DISC
#include "stage/tile_disc.glsl"
#endif
#ifdef TILES_INTERPOLATED
#include "stage/tile_fit.glsl"
#endif
#ifdef CROSSINGS_TOLD
#include "stage/disc_fit.glsl"
#endif

vec4 tile_texel(ivec2 tile) {
    vec4 bodies = vec4(0.0);
    bool sky = true;
#ifdef TILES_OF_BODIES
    vec4 set = texel_of(tile_bodies(picture_place((vec2(tile) + 0.5) * tile_side()), tile_among(tile)));
    bodies = set;
    sky = max(max(bodies.x, bodies.y), max(bodies.z, bodies.w)) == 0.0;
#endif
#ifdef TILES_OF_DISC
    float disc = tile_of_disc(tile);
#ifdef CROSSINGS_TOLD
    int crossing = int(max(TILE_TOLD - disc, 0.0));
    float through = disc_fit_through(tile, crossing);
    bool told = disc_fits(tile, crossing) && (through == 0.0 || tile_interpolates(tile, max(through, DISC_FIT_THROUGH)));
    disc = disc > TILE_TOLD || told ? disc : 0.0;
#endif
    if (sky && disc <= TILE_FULL) bodies = vec4(disc);
    sky = sky && disc == TILE_SKY;
#else
#ifdef EFFECT_DISC
    sky = false;
#endif
#endif
    float kind = TILE_SKY;
#ifdef TILES_INTERPOLATED
    kind = tile_interpolates(tile, 1.0) ? TILE_INTERPOLATED : TILE_SKY;
#endif
    vec4 texel = sky ? vec4(kind) : bodies;
#ifdef TILES_OF_BODIES
    texel = tile_scale > 1 ? set : texel;
#endif
    return texel;
}
