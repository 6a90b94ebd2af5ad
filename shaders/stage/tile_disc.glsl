// Do the rays of a tile pass the disc clear of it, or does it cover them all? By where the tile's own (stage/tile_rays.glsl) cross its plane:
// the others do so in a circle about these places.
#include "shared/frame.glsl"
#include "stage/tile_kind.glsl"
#include "stage/tile_places.glsl"
#include "stage/tile_rays.glsl"

#ifdef TILES_OF_FULL_DISC
#ifdef EFFECT_DISC_IMAGE
uniform sampler2D disc_texture;
#endif
#endif

#define TILE_SPREAD_MORE 1.25   // the circle's radius over that of the five
#define TILE_RIM 0.25           // of that radius, more than a pixel: beside a rim
#define TILE_FAR 2.0            // of the outer radius: crossings beyond it may be some of the rays' alone

// Crossing k of the five rays.
struct TileCrossing {
    bool clear;   // of the disc
    bool full;    // within it, in its opaque part
    bool met;     // all of them have it
};

// Where others of the tile do not cross the plane: does this one not either, or so far out and on its way out that those
// between cross it farther still?
bool tile_leaves(vec2 place) {
    float r2 = dot(place, place);
    float far = TILE_FAR * frame.disc_y.w;
    vec2 camera = vec2(dot(frame.radial.xyz, frame.disc_x.xyz), dot(frame.radial.xyz, frame.disc_y.xyz)) / frame.shift.y;
    return r2 == 0.0 || (r2 > far * far && r2 > dot(place, camera));
}

TileCrossing tile_crossing(vec2 a, vec2 b, vec2 c, vec2 d, vec2 e) {
    vec2 mean = 0.2 * (a + b + c + d + e);
    vec4 off2 = vec4(dot(a - mean, a - mean), dot(b - mean, b - mean), dot(c - mean, c - mean), dot(d - mean, d - mean));
    float spread = TILE_SPREAD_MORE * sqrt(max(max(max(off2.x, off2.y), max(off2.z, off2.w)), dot(e - mean, e - mean)));
    float from = length(mean) - spread;
    float to = length(mean) + spread;
    float least2 = min(min(min(dot(a, a), dot(b, b)), min(dot(c, c), dot(d, d))), dot(e, e));   // 0 where there is no crossing
    bool leave = tile_leaves(a) && tile_leaves(b) && tile_leaves(c) && tile_leaves(d) && tile_leaves(e);
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    float rim = TILE_RIM * spread;
    TileCrossing crossing;
    crossing.clear = least2 == 0.0 ? leave : from > outer + rim || to < inner - rim;
    crossing.met = least2 > 0.0;
#ifdef EFFECT_TRANSLUCENT_DISC
    rim += frame.disc_surface.x < 1.0 ? outer : frame.disc_surface.y * (outer - inner);
#endif
    crossing.full = least2 > 0.0 && from > inner + rim && to < outer - rim;
    return crossing;
}

// TILE_SKY; TILE_FULL, or TILE_TOLD where that is interpolated, less the number of the crossing; or 0 where neither is sure.
float tile_of_disc(ivec2 tile) {
    vec4 p = texelFetch(places_texture, texel_of_corner(tile), 0);
    vec4 q = texelFetch(places_texture, texel_of_corner(tile + ivec2(1, 0)), 0);
    vec4 r = texelFetch(places_texture, texel_of_corner(tile + ivec2(0, 1)), 0);
    vec4 s = texelFetch(places_texture, texel_of_corner(tile + ivec2(1, 1)), 0);
    vec4 t = texelFetch(places_texture, texel_of_middle(tile), 0);
    TileCrossing first = tile_crossing(p.xy, q.xy, r.xy, s.xy, t.xy);
    TileCrossing second = tile_crossing(p.zw, q.zw, r.zw, s.zw, t.zw);
    float kind = first.clear && second.clear && tile_ends_alike(tile) ? TILE_SKY : 0.0;
#ifdef TILES_OF_FULL_DISC
    bool opaque = true;
#ifdef EFFECT_DISC_IMAGE
    opaque = textureLod(disc_texture, vec2(0.5), 20.0).a == 1.0;   // the mean of all
#endif
    int passed = int(frame.disc_surface.w);   // crossings that are not drawn
    if (opaque && passed == 0) kind = first.full ? TILE_FULL : first.clear && second.full ? TILE_FULL - 1.0 : kind;
#endif
#ifdef CROSSINGS_TOLD
    bool one = kind != TILE_SKY && frame.disc_surface.w == 0.0;
    if (one) kind = first.met && second.clear ? TILE_TOLD : first.clear && second.met ? TILE_TOLD - 1.0 : kind;
#endif
    return kind;
}
