// Is a tile of the picture, by its texel (stage/tiles.frag), one of those that a stage draws?
#include "core/tile_bodies.glsl"
#include "generated/tiles"
#include "stage/tile_kind.glsl"

float tile_most(vec4 set) { return max(max(set.x, set.y), max(set.z, set.w)); }

#ifdef TILES_BY_MOTION
// Tiles of bodies in two parts: those where none can be seen that changes with time, and the others.
bool tile_of_motion(vec4 set) {
    bool moves = (tile_bodies_of(set).set & TILES_MOVING) != uvec2(0u, 0u);
#ifdef TILES_OF_STILL_BODIES
    return !moves;
#else
    return moves;
#endif
}
#else
bool tile_of_motion(vec4 set) { return true; }
#endif

bool tile_drawn(vec4 set) {
#ifdef TILES_WITH_BODIES
    return tile_most(set) > 0.0 && tile_of_motion(set);
#endif
#ifdef TILES_OF_SKY
    return tile_most(set) == TILE_SKY;
#endif
#ifdef TILES_OF_FULL_DISC
    return tile_most(set) <= TILE_FULL;
#endif
#ifdef TILES_OF_THE_REST
    return tile_most(set) == 0.0;
#endif
}
