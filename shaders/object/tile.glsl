// May a tile of the picture show a body? Its middle ray is followed beside the rays through its corners. None of the tile's rays meets a body
// where that is farther from the middle ray than they are, which the corners' rays and straight light tell.
#include "generated/bodies_march"
#include "generated/tiles"
#include "path/place"

#define TILE_RAYS 5
#define TILE_REACH (0.5 * float(TILE_SIDE) + 1.0)   // px from the middle to the sides, and a pixel for edges that are blurred
#define TILE_SPREAD 1.5    // how much farther from the middle ray a ray of the tile may be than the farthest of the corners'
#define TILE_WIDEST 0.6   // of the radius: rays farther apart are no bundle
#define TILE_LEAST 0.1     // of the spread, left to the nearest body
#define TILE_STEP 0.7      // of the way that is free of bodies
#define TILE_LOOKS 128

// From the tile's middle, px. 0: the middle.
vec2 tile_ray(int k) {
    vec2 corner = vec2(k % 2 == 0 ? TILE_REACH : -TILE_REACH, k < 3 ? TILE_REACH : -TILE_REACH);
    return k == 0 ? vec2(0.0, 0.0) : corner;
}

// What is known of the rays at one place of the middle's.
struct TileLook {
    bool clear;    // no ray of the tile is at a body there
    float free;    // how far on that stays so, r_s
    float spread;  // how far from the middle ray they are there
};

// offset: the longest way from the middle ray's place to a corner's; across: the longest across the ray; way: from the camera.
TileLook tile_look(RayPlace place, float offset, float across, float way, float pixel_angle) {
    float spread = max(TILE_SPREAD * (across + 0.5 * offset * offset / place.r), 1.5 * TILE_REACH * pixel_angle * way);
    TileLook look;
    look.spread = spread;
    look.free = march_clear(place) - spread;
    look.clear = look.free > max(TILE_LEAST * spread, frame.march.y) && offset < TILE_WIDEST * place.r;   // not where they are no numbers
    return look;
}

// From the middle ray's place to another's: its length, and across the ray.
vec2 tile_offset(RayPlace place, vec3 other) {
    vec3 off = other - place.at;
    vec3 ahead = place_velocity(place) / max(place_speed(place), 1.0e-20);
    vec3 across = off - dot(off, ahead) * ahead;
    return vec2(sqrt(dot(off, off)), sqrt(dot(across, across)));
}
