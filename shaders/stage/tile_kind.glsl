// The picture's tiles, which are drawn as points, and what a tile's texel says in place of a set of bodies (core/bits.glsl).
#define TILE_INTERPOLATED -2.0   // the sky alone, its rays interpolated
#define TILE_SKY -1.0            // the sky alone: neither body nor disc
#define TILE_FULL -3.0           // the disc alone, at its first crossing; -4: at its second
#define TILE_TOLD -5.0           // the disc at its first crossing, interpolated with the rays, and the sky behind it; -6: at its second
