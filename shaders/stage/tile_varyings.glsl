// A tile whose rays are interpolated, as its fragments have it (stage/interpolated.vert).
#include "core/view.glsl"
#include "effect/sampling.glsl"
#include "shared/frame.glsl"
#include "stage/tile_sky.glsl"

flat in highp vec3 tile_at;
flat in highp vec4 tile_detail;
flat in highp vec3 tile_sky_00;
flat in highp vec3 tile_sky_10;
flat in highp vec3 tile_sky_01;
flat in highp vec3 tile_sky_20;
flat in highp vec3 tile_sky_11;
flat in highp vec3 tile_sky_02;
flat in highp vec3 tile_sky_30;
flat in highp vec3 tile_sky_21;
flat in highp vec3 tile_sky_12;
flat in highp vec3 tile_sky_03;

TileSky tile_sky() {
    return TileSky(tile_sky_00, tile_sky_10, tile_sky_01, tile_sky_20, tile_sky_11, tile_sky_02, tile_sky_30, tile_sky_21, tile_sky_12,
                   tile_sky_03);
}

// From the tile's middle, of a fragment_pixel().
vec2 tile_place(vec2 pixel) {
    return (picture_fragment(pixel) * sampling_px() - tile_at.xy) * (1.0 / float(TILE_SIDE));
}
bool tile_escapes() { return tile_at.z > 0.0; }
