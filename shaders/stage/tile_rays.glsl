// The rays through the corners of the picture's tiles, and where rays are interpolated through their middles (stage/corner_ray.glsl): a row of texels
// has RAYS_A_TILE of them for each tile, corner first. Of the tiles that surround the picture there are some too.
#include "generated/tiles"

#define RAY_TANGLED 0.0    // what a ray's texel says in w: it crosses the disc's plane more often than is told ...
#define RAY_ESCAPES 1.0    // ... it reaches the sky in the direction xyz ...
#define RAY_CAPTURED 2.0   // ... or not

uniform highp sampler2D ray_texture;

// Texels of the corner at the lower left of a tile, and of its middle; of that corner where middles are not told.
ivec2 texel_of_corner(ivec2 tile) { return ivec2((tile.x + 1) * RAYS_A_TILE, tile.y + 1); }
ivec2 texel_of_middle(ivec2 tile) { return texel_of_corner(tile) + ivec2(RAYS_A_TILE - 1, 0); }

vec4 ray_of_corner(ivec2 tile) { return texelFetch(ray_texture, texel_of_corner(tile), 0); }
vec4 ray_of_middle(ivec2 tile) { return texelFetch(ray_texture, texel_of_middle(tile), 0); }

// Do the rays through a tile's corners and its middle end alike?
bool tile_ends_alike(ivec2 tile) {
    float w = ray_of_middle(tile).w;
    return w != RAY_TANGLED && ray_of_corner(tile).w == w && ray_of_corner(tile + ivec2(1, 0)).w == w &&
           ray_of_corner(tile + ivec2(0, 1)).w == w && ray_of_corner(tile + ivec2(1, 1)).w == w;
}
