// What changes smoothly over a tile of the picture: four numbers, each a cubic of the place in it, counted from its middle in tiles, -0.5 ... 0.5.
#include "generated/tiles"

struct TilePolynomial {   // of x^i y^j
    vec4 c00;
    vec4 c10;
    vec4 c01;
    vec4 c20;
    vec4 c11;
    vec4 c02;
    vec4 c30;
    vec4 c21;
    vec4 c12;
    vec4 c03;
};

vec4 polynomial_at(TilePolynomial p, vec2 at) {
    vec4 row = p.c00 + at.y * (p.c01 + at.y * (p.c02 + at.y * p.c03));
    vec4 slope = p.c10 + at.y * (p.c11 + at.y * p.c12);
    return row + at.x * (slope + at.x * (p.c20 + at.y * p.c21 + at.x * p.c30));
}

// How it moves from pixel to pixel, to the right and upward.
vec4 polynomial_right(TilePolynomial p, vec2 at) {
    vec4 slope = p.c10 + at.y * (p.c11 + at.y * p.c12);
    return (slope + at.x * (2.0 * (p.c20 + at.y * p.c21) + at.x * (3.0 * p.c30))) * (1.0 / float(TILE_SIDE));
}

vec4 polynomial_up(TilePolynomial p, vec2 at) {
    vec4 slope = p.c01 + at.x * (p.c11 + at.x * p.c21);
    return (slope + at.y * (2.0 * (p.c02 + at.x * p.c12) + at.y * (3.0 * p.c03))) * (1.0 / float(TILE_SIDE));
}
