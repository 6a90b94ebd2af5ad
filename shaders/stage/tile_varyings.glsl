// A tile whose rays are interpolated, as its fragments have it (stage/interpolated.vert).
#include "core/view.glsl"
#include "effect/sampling.glsl"
#include "shared/frame.glsl"
#include "stage/tile_polynomial.glsl"

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
#ifdef INTERPOLATED_DISC
flat in highp vec4 tile_told;           // the number of the crossing; disc_fit_other()
flat in highp vec4 tile_disc_00;   // stage/disc_fit.glsl
flat in highp vec4 tile_disc_10;
flat in highp vec4 tile_disc_01;
flat in highp vec4 tile_disc_20;
flat in highp vec4 tile_disc_11;
flat in highp vec4 tile_disc_02;
flat in highp vec4 tile_disc_30;
flat in highp vec4 tile_disc_21;
flat in highp vec4 tile_disc_12;
flat in highp vec4 tile_disc_03;
#endif

// The sky's direction; unit to what the cubic leaves out.
TilePolynomial tile_sky() {
    return TilePolynomial(vec4(tile_sky_00, 0.0), vec4(tile_sky_10, 0.0), vec4(tile_sky_01, 0.0), vec4(tile_sky_20, 0.0), vec4(tile_sky_11, 0.0),
                          vec4(tile_sky_02, 0.0), vec4(tile_sky_30, 0.0), vec4(tile_sky_21, 0.0), vec4(tile_sky_12, 0.0), vec4(tile_sky_03, 0.0));
}

#ifdef INTERPOLATED_DISC
TilePolynomial tile_disc() {
    return TilePolynomial(tile_disc_00, tile_disc_10, tile_disc_01, tile_disc_20, tile_disc_11,
                          tile_disc_02, tile_disc_30, tile_disc_21, tile_disc_12, tile_disc_03);
}
#endif

// From the tile's middle, of a fragment_pixel().
vec2 tile_place(vec2 pixel) {
    return (picture_fragment(pixel) * sampling_px() - tile_at.xy) * (1.0 / float(TILE_SIDE));
}
bool tile_escapes() { return tile_at.z > 0.0; }
