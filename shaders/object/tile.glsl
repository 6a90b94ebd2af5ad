// Which bodies may a tile of the picture show? Its middle ray is followed beside the rays through its corners. None of the tile's rays meets a
// body that is farther from the middle ray everywhere than they are, which the corners' rays and straight light tell.
#include "core/pixel_view.glsl"
#include "generated/bodies_march"
#include "generated/tiles"
#include "path/place"

#define TILE_ALL uvec2(0xffffffffu, 0xffffffffu)
#define TILE_RAYS 5
#define TILE_SPREAD 1.5    // how much farther from the middle ray a ray of the tile may be than the farthest of the corners'
#define TILE_WIDEST 0.6    // of the radius: rays farther apart are no bundle
#define TILE_LEAST 0.1     // of the spread, left to the nearest body
#define TILE_STEP 0.7      // of the way that is free of bodies
#define TILE_LOOKS 128
#define TILE_NONE 1.0e29   // free: there are no others

uniform int tile_scale;   // FIRST_TILES: of the first pass, whose tiles are so many times as wide; 1

float tile_side() { return float(TILE_SIDE * tile_scale); }
float tile_reach() { return 0.5 * tile_side() + 1.0; }   // pixels from the middle to the sides, and one for edges that are blurred
float tile_longest() { return tile_reach() * pixel_longest(); }   // ... at most, by the angle that a pixel spans

// From the tile's middle, px of a pixel's height. 0: the middle.
vec2 tile_ray(int k) {
    if (k == 0) return vec2(0.0, 0.0);
    float up = tile_reach();
    float right = up * frame.sight.z;
    return vec2(k < 3 ? -right : right, k == 1 || k == 3 ? -up : up);
}

// Where the corners' rays are next to a place of the middle's.
struct TileSpread {
    float offset;   // the longest way to one of them, r_s
    float across;   // the longest where they pass the plane across the middle ray
};

TileSpread tile_together() {
    TileSpread spread;
    spread.offset = 0.0;
    spread.across = 0.0;
    return spread;
}

// Of another ray's place from the middle's: how far it is ahead, r_s.
float tile_ahead(RayPlace place, vec3 off) { return dot(off, place_velocity(place)) / max(place_speed(place), 1.0e-20); }

#define TILE_FAN 2.0   // how much the directions of rays that are `across` apart may differ, times across/r

// A ray bends by no more than 3/(2 r^2) a length, r_s = 1, or by 1/r.
TileSpread tile_spread(TileSpread spread, RayPlace place, vec3 off) {
    float along = abs(tile_ahead(place, off));
    float length2 = dot(off, off);
    float across = sqrt(max(length2 - along * along, 0.0)) * (1.0 + TILE_FAN * along / place.r);
    float bent = 0.5 * along * along / place.r * min(1.0, 3.0 / place.r);
    spread.offset = max(spread.offset, sqrt(length2));
    spread.across = max(spread.across, across + bent);
    return spread;
}

// What is known of the rays at one place of the middle's.
struct TileLook {
    bool bundle;   // the rays keep together
    uvec2 bodies;  // that a ray of the tile may be at there, and those known before
    float free;    // how far on none of the others is, r_s
    float nearest; // how far on none at all is
    float spread;  // how far from the middle ray they are there
};

// way: from the camera.
TileLook tile_look(RayPlace place, TileSpread corners, float way, float pixel_angle, uvec2 bodies) {
    TileLook look;
    look.spread = max(TILE_SPREAD * corners.across, 1.5 * tile_longest() * pixel_angle * way);
    look.bodies = bodies;
    vec2 clear = march_clear(place, look.spread + max(TILE_LEAST * look.spread, frame.march.y), look.bodies) - look.spread;
    look.free = clear.x;
    look.nearest = clear.y;
    look.bundle = corners.offset < TILE_WIDEST * place.r;   // not where they are no numbers
    return look;
}
