// The sky's direction over a tile (stage/tile_sky.glsl) by rays: the tensor product of the cubics through four by four corners, of the tile and
// its neighbours, less its terms of more than the third degree.
#include "core/pixel_sides.glsl"
#include "stage/tile_rays.glsl"
#include "stage/tile_sky.glsl"

// The cubic through values at -1.5, -0.5, 0.5, 1.5, by powers.
struct TileCubic {
    vec3 c0;
    vec3 c1;
    vec3 c2;
    vec3 c3;
};

TileCubic tile_cubic(vec3 a, vec3 b, vec3 c, vec3 d) {
    vec3 inner = b + c;
    vec3 outer = a + d;
    vec3 slope = c - b;
    vec3 wide = d - a;
    TileCubic cubic;
    cubic.c0 = (9.0 * inner - outer) * (1.0 / 16.0);
    cubic.c1 = (27.0 * slope - wide) * (1.0 / 24.0);
    cubic.c2 = (outer - inner) * 0.25;
    cubic.c3 = (wide - 3.0 * slope) * (1.0 / 6.0);
    return cubic;
}

TileCubic tile_row(ivec2 tile, int y) {
    return tile_cubic(ray_of_corner(tile + ivec2(-1, y)).xyz, ray_of_corner(tile + ivec2(0, y)).xyz,
                      ray_of_corner(tile + ivec2(1, y)).xyz, ray_of_corner(tile + ivec2(2, y)).xyz);
}

struct TileFit {
    TileSky sky;
    float rest;   // what the terms left out amount to in the tile's corners, together
};

TileFit tile_fit(ivec2 tile) {
    TileCubic below = tile_row(tile, -1);
    TileCubic low = tile_row(tile, 0);
    TileCubic high = tile_row(tile, 1);
    TileCubic above = tile_row(tile, 2);
    TileCubic x0 = tile_cubic(below.c0, low.c0, high.c0, above.c0);
    TileCubic x1 = tile_cubic(below.c1, low.c1, high.c1, above.c1);
    TileCubic x2 = tile_cubic(below.c2, low.c2, high.c2, above.c2);
    TileCubic x3 = tile_cubic(below.c3, low.c3, high.c3, above.c3);
    TileFit fit;
    fit.sky = TileSky(x0.c0, x1.c0, x0.c1, x2.c0, x1.c1, x0.c2, x3.c0, x2.c1, x1.c2, x0.c3);
    fit.rest = (length(x2.c2) + length(x3.c1) + length(x1.c3)) * (1.0 / 16.0);
    return fit;
}

#define TILE_SKY_ERROR 2.0e-3      // of what a pixel spans on the sky
#define TILE_SKY_ROUNDING 1.0e-6   // rad, of the rays that are traced

// Do all the rays that the cubic is made of end alike, and is it the tile's middle ray that it has in its middle?
bool tile_interpolates(ivec2 tile) {
    vec4 middle = ray_of_middle(tile);
    bool alike = middle.w != RAY_TANGLED;
    for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) alike = alike && ray_of_corner(tile + ivec2(x, y)).w == middle.w;
    TileFit fit = tile_fit(tile);
    float shorter = sides_stretch(PixelSides(tile_sky_right(fit.sky, vec2(0.0)), tile_sky_up(fit.sky, vec2(0.0))), 1.0).y;
    float error = length(fit.sky.c00 - middle.xyz) + fit.rest;
    return alike && (middle.w == RAY_CAPTURED || error < max(TILE_SKY_ERROR * shorter, TILE_SKY_ROUNDING));
}
