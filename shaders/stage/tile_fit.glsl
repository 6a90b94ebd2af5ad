// The sky's direction over a tile (stage/tile_polynomial.glsl) by rays through corners.
#include "core/pixel_sides.glsl"
#include "stage/tile_cubic.glsl"
#include "stage/tile_rays.glsl"

TileCubic tile_row(ivec2 tile, int y) {
    return tile_cubic(ray_of_corner(tile + ivec2(-1, y)), ray_of_corner(tile + ivec2(0, y)), ray_of_corner(tile + ivec2(1, y)),
                      ray_of_corner(tile + ivec2(2, y)));
}

TileFit tile_fit(ivec2 tile) { return tile_fit_of(tile_row(tile, -1), tile_row(tile, 0), tile_row(tile, 1), tile_row(tile, 2)); }

#define TILE_SKY_ERROR 2.0e-3      // of what a pixel spans on the sky
#define TILE_SKY_ROUNDING 1.0e-6   // rad, of the rays that are traced

// Do all the rays that the cubic is made of end alike?
bool tile_fit_ends_alike(ivec2 tile) {
    float end = ray_of_middle(tile).w;
    bool alike = end != RAY_TANGLED;
    for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) alike = alike && ray_of_corner(tile + ivec2(x, y)).w == end;
    return alike;
}

// And is it the tile's middle ray that it has in its middle? through: how much of the sky's light is seen.
bool tile_interpolates(ivec2 tile, float through) {
    vec4 middle = ray_of_middle(tile);
    TileFit fit = tile_fit(tile);
    float shorter = sides_stretch(PixelSides(polynomial_right(fit.told, vec2(0.0)).xyz, polynomial_up(fit.told, vec2(0.0)).xyz), 1.0).y;
    float error = length(fit.told.c00.xyz - middle.xyz) + length(fit.rest.xyz);
    return tile_fit_ends_alike(tile) && (middle.w == RAY_CAPTURED || through * error < max(TILE_SKY_ERROR * shorter, TILE_SKY_ROUNDING));
}
