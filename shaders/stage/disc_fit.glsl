// Where the rays of a tile cross the disc about a rotating hole, if all do so once: a polynomial (stage/tile_polynomial.glsl) of place, delay and
// d zeta/d tau, by rays through corners.
#include "object/disc_rim.glsl"
#include "shared/frame.glsl"
#include "stage/tile_cubic.glsl"
#include "stage/tile_places.glsl"
#include "stage/tile_rays.glsl"

#ifdef EFFECT_DISC_IMAGE
uniform sampler2D disc_texture;
#endif

#define DISC_FIT_ERROR 4.0e-3      // of a pixel there; and of the way that light makes while it is late by the error of the delay
#define DISC_FIT_ROUNDING 2.0e-6   // of the radius, of the rays that are traced
#define DISC_FIT_REACH 1.6         // of the corners' distance from their mean: others of the tile cross in that circle about it, and their pixels
#define DISC_FIT_THROUGH 0.1        // less of the sky is not told apart: gaps of gas show several times the mean
#define DISC_FIT_SHIFT 2.0e-5      // of d zeta/d tau, whose unit is the photon's frequency at the camera: of the shift, where gas falls inward

TileCubic disc_row(ivec2 tile, int k, int y) {
    return tile_cubic(crossing_of(texel_of_corner(tile + ivec2(-1, y)), k), crossing_of(texel_of_corner(tile + ivec2(0, y)), k),
                      crossing_of(texel_of_corner(tile + ivec2(1, y)), k), crossing_of(texel_of_corner(tile + ivec2(2, y)), k));
}

TileFit disc_fit(ivec2 tile, int k) { return tile_fit_of(disc_row(tile, k, -1), disc_row(tile, k, 0), disc_row(tile, k, 1), disc_row(tile, k, 2)); }

// Has each of the rays that it is made of this crossing?
bool disc_fit_whole(ivec2 tile, int k) {
    bool whole = true;
    for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) {
            vec2 place = crossing_of(texel_of_corner(tile + ivec2(x, y)), k).xy;
            whole = whole && dot(place, place) > 0.0;
        }
    return whole;
}

// And is it that of the tile's middle ray in its middle?
bool disc_fits(ivec2 tile, int k) {
    vec4 middle = crossing_of(texel_of_middle(tile), k);
    TileFit fit = disc_fit(tile, k);
    vec4 off = abs(fit.told.c00 - middle) + fit.rest;
    vec2 right = polynomial_right(fit.told, vec2(0.0)).xy;
    vec2 up = polynomial_up(fit.told, vec2(0.0)).xy;
    float area = abs(right.x * up.y - right.y * up.x);
    float longer = sqrt(max(dot(right, right), dot(up, up)));
    // By the inverse of (right, up).
    float off_px = max(abs(up.y) * off.x + abs(up.x) * off.y, abs(right.y) * off.x + abs(right.x) * off.y);
    float rounding = DISC_FIT_ROUNDING * length(middle.xy) * longer;
    return disc_fit_whole(tile, k) && max(off_px, off.z * longer) < max(DISC_FIT_ERROR * area, rounding) && off.w < DISC_FIT_SHIFT;
}

// How much of the light behind shines through the disc where it does so most, but for gaps of its gas.
float disc_fit_through(ivec2 tile, int k) {
    bool opaque = true;
#ifdef EFFECT_DISC_IMAGE
    opaque = textureLod(disc_texture, vec2(0.5), 20.0).a == 1.0;   // the mean of all
#endif
    vec2 a = crossing_of(texel_of_corner(tile), k).xy;
    vec2 b = crossing_of(texel_of_corner(tile + ivec2(1, 0)), k).xy;
    vec2 c = crossing_of(texel_of_corner(tile + ivec2(0, 1)), k).xy;
    vec2 d = crossing_of(texel_of_corner(tile + ivec2(1, 1)), k).xy;
    vec2 mean = 0.25 * (a + b + c + d);
    float reach = DISC_FIT_REACH * max(max(distance(a, mean), distance(b, mean)), max(distance(c, mean), distance(d, mean)));
    float depth = min(length(mean) - reach - frame.disc_x.w, frame.disc_y.w - length(mean) - reach);
#ifdef EFFECT_TRANSLUCENT_DISC
    float cover = frame.disc_surface.x * disc_whole(depth);
#else
    float cover = 1.0;
#endif
    return opaque && depth > 0.0 ? 1.0 - cover : 1.0;
}

// What the other crossing, of the middle ray, adds to the way (mino/ray_way.glsl): within and beyond, as KeptCrossings; and whether it comes first, on
// the way in.
vec3 disc_fit_other(ivec2 tile, int k) {
    vec4 other = crossing_of(texel_of_middle(tile), 1 - k);
    float r = length(other.xy);
    return vec3(r > 0.0 && r < frame.disc_x.w ? 1.0 : 0.0, r > frame.disc_y.w ? 1.0 : 0.0, k == 1 && r > frame.disc_y.w && other.w > 0.0 ? 1.0 : 0.0);
}
