// A tile of the picture whose rays are interpolated, as a point.
#include "core/view.glsl"
#include "effect/sampling.glsl"
#ifdef EFFECT_SKY
#include "object/celestial_sphere.glsl"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#ifdef INTERPOLATED_DISC
#include "stage/disc_fit.glsl"
#endif
#include "stage/tile_fit.glsl"
#include "stage/tile_kind.glsl"
#include "stage/tile_point.glsl"

uniform highp sampler2D tile_texture;   // stage/tile_texel.glsl
flat out highp vec3 tile_at;            // the tile's middle, px from the picture's lower left; 1 if its rays escape
flat out highp vec4 tile_detail;        // log2 of the footprint on the sky's texture, texels: of 1, x, y, x y
flat out highp vec3 tile_sky_00;        // TilePolynomial
flat out highp vec3 tile_sky_10;
flat out highp vec3 tile_sky_01;
flat out highp vec3 tile_sky_20;
flat out highp vec3 tile_sky_11;
flat out highp vec3 tile_sky_02;
flat out highp vec3 tile_sky_30;
flat out highp vec3 tile_sky_21;
flat out highp vec3 tile_sky_12;
flat out highp vec3 tile_sky_03;
#ifdef INTERPOLATED_DISC
flat out highp vec4 tile_told;          // the number of the crossing; disc_fit_other()
flat out highp vec4 tile_disc_00;  // stage/disc_fit.glsl
flat out highp vec4 tile_disc_10;
flat out highp vec4 tile_disc_01;
flat out highp vec4 tile_disc_20;
flat out highp vec4 tile_disc_11;
flat out highp vec4 tile_disc_02;
flat out highp vec4 tile_disc_30;
flat out highp vec4 tile_disc_21;
flat out highp vec4 tile_disc_12;
flat out highp vec4 tile_disc_03;
#endif

#ifdef EFFECT_SKY
float detail_at(TilePolynomial sky, vec2 middle, vec2 at) {
    vec2 pixel = middle + at * (float(TILE_SIDE) * sampling_rays());
    return sky_detail(trace_to_sky(pixel, polynomial_at(sky, at).xyz, polynomial_right(sky, at).xyz * sampling_px(), polynomial_up(sky, at).xyz * sampling_px()));
}
#endif

void main() {
    ivec2 tiles = textureSize(tile_texture, 0);
    ivec2 tile = tile_of_point(gl_VertexID, tiles);
    TilePolynomial sky = tile_fit(tile).told;
    tile_at = vec3((vec2(tile) + 0.5) * float(TILE_SIDE), ray_of_middle(tile).w == RAY_ESCAPES ? 1.0 : 0.0);
    tile_detail = vec4(0.0);
#ifdef EFFECT_SKY
    // Bilinear between the corners: the neighbours have the same there.
    vec2 pixel = picture_place(tile_at.xy * sampling_rays());
    float a = detail_at(sky, pixel, vec2(-0.5, -0.5));
    float b = detail_at(sky, pixel, vec2(0.5, -0.5));
    float c = detail_at(sky, pixel, vec2(-0.5, 0.5));
    float d = detail_at(sky, pixel, vec2(0.5, 0.5));
    tile_detail = vec4(0.25 * (a + b + c + d), 0.5 * (b + d - a - c), 0.5 * (c + d - a - b), a + d - b - c);
#endif
    tile_sky_00 = sky.c00.xyz;
    tile_sky_10 = sky.c10.xyz;
    tile_sky_01 = sky.c01.xyz;
    tile_sky_20 = sky.c20.xyz;
    tile_sky_11 = sky.c11.xyz;
    tile_sky_02 = sky.c02.xyz;
    tile_sky_30 = sky.c30.xyz;
    tile_sky_21 = sky.c21.xyz;
    tile_sky_12 = sky.c12.xyz;
    tile_sky_03 = sky.c03.xyz;
    float kind = texelFetch(tile_texture, tile, 0).x;
#ifdef INTERPOLATED_DISC
    bool drawn = kind <= TILE_TOLD;
    int crossing = int(max(TILE_TOLD - kind, 0.0));
    TilePolynomial disc = disc_fit(tile, crossing).told;
    tile_told = vec4(float(crossing), disc_fit_other(tile, crossing));
    tile_disc_00 = disc.c00;
    tile_disc_10 = disc.c10;
    tile_disc_01 = disc.c01;
    tile_disc_20 = disc.c20;
    tile_disc_11 = disc.c11;
    tile_disc_02 = disc.c02;
    tile_disc_30 = disc.c30;
    tile_disc_21 = disc.c21;
    tile_disc_12 = disc.c12;
    tile_disc_03 = disc.c03;
#else
    bool drawn = kind == TILE_INTERPOLATED;
#endif
    place_point(gl_VertexID, tiles, drawn);
}
