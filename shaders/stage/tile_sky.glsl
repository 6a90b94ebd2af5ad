// The sky's direction over a tile of the picture: a cubic of the place in it, counted from its middle in tiles, -0.5 ... 0.5.
#include "generated/tiles"

struct TileSky {   // of x^i y^j
    vec3 c00;
    vec3 c10;
    vec3 c01;
    vec3 c20;
    vec3 c11;
    vec3 c02;
    vec3 c30;
    vec3 c21;
    vec3 c12;
    vec3 c03;
};

// Unit to what the cubic leaves out.
vec3 tile_sky_at(TileSky sky, vec2 at) {
    vec3 row = sky.c00 + at.y * (sky.c01 + at.y * (sky.c02 + at.y * sky.c03));
    vec3 slope = sky.c10 + at.y * (sky.c11 + at.y * sky.c12);
    return row + at.x * (slope + at.x * (sky.c20 + at.y * sky.c21 + at.x * sky.c30));
}

// How it moves from pixel to pixel, to the right and upward.
vec3 tile_sky_right(TileSky sky, vec2 at) {
    vec3 slope = sky.c10 + at.y * (sky.c11 + at.y * sky.c12);
    return (slope + at.x * (2.0 * (sky.c20 + at.y * sky.c21) + at.x * (3.0 * sky.c30))) * (1.0 / float(TILE_SIDE));
}

vec3 tile_sky_up(TileSky sky, vec2 at) {
    vec3 slope = sky.c01 + at.x * (sky.c11 + at.x * sky.c21);
    return (slope + at.y * (2.0 * (sky.c02 + at.x * sky.c12) + at.y * (3.0 * sky.c03))) * (1.0 / float(TILE_SIDE));
}
