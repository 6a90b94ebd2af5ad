// The polynomial of a tile (stage/tile_polynomial.glsl) by what is known at four by four corners, of the tile and its neighbours: the tensor product of
// the cubics through them, less its terms of more than the third degree.
#include "stage/tile_polynomial.glsl"

// The cubic through values at -1.5, -0.5, 0.5, 1.5, by powers.
struct TileCubic {
    vec4 c0;
    vec4 c1;
    vec4 c2;
    vec4 c3;
};

TileCubic tile_cubic(vec4 a, vec4 b, vec4 c, vec4 d) {
    vec4 inner = b + c;
    vec4 outer = a + d;
    vec4 slope = c - b;
    vec4 wide = d - a;
    TileCubic cubic;
    cubic.c0 = (9.0 * inner - outer) * (1.0 / 16.0);
    cubic.c1 = (27.0 * slope - wide) * (1.0 / 24.0);
    cubic.c2 = (outer - inner) * 0.25;
    cubic.c3 = (wide - 3.0 * slope) * (1.0 / 6.0);
    return cubic;
}

struct TileFit {
    TilePolynomial told;
    vec4 rest;   // what the terms left out amount to in the tile's corners, at most
};

// Of the four rows' cubics, from below.
TileFit tile_fit_of(TileCubic below, TileCubic low, TileCubic high, TileCubic above) {
    TileCubic x0 = tile_cubic(below.c0, low.c0, high.c0, above.c0);
    TileCubic x1 = tile_cubic(below.c1, low.c1, high.c1, above.c1);
    TileCubic x2 = tile_cubic(below.c2, low.c2, high.c2, above.c2);
    TileCubic x3 = tile_cubic(below.c3, low.c3, high.c3, above.c3);
    TileFit fit;
    fit.told = TilePolynomial(x0.c0, x1.c0, x0.c1, x2.c0, x1.c1, x0.c2, x3.c0, x2.c1, x1.c2, x0.c3);
    fit.rest = (abs(x2.c2) + abs(x3.c1) + abs(x1.c3)) * (1.0 / 16.0);
    return fit;
}
