// The bodies that a tile of the picture may show (core/bits.glsl), and the part of its rays on which they may be met.

// Of the swept angle: none is met before `first` or behind `last`. Paths that are not told by a swept angle have the whole way.
struct TileBodies {
    uvec2 set;
    float first;
    float last;
};

#define TILE_WAY_END 1.0e30

TileBodies tile_whole_way(uvec2 set) { return TileBodies(set, 0.0, TILE_WAY_END); }

// As a texel of floats, whole numbers of 24 bits: 16 bits of the set a channel, and above them 8 of the upper halves of first and last, which
// keep eight binary digits, rounded down and up. An empty set is 0.
vec4 texel_of(TileBodies bodies) {
    uint from = floatBitsToUint(bodies.first) >> 16u;
    uint to = (floatBitsToUint(bodies.last) + 65535u) >> 16u;
    uvec4 low = uvec4(bodies.set.x & 65535u, bodies.set.x >> 16u, bodies.set.y & 65535u, bodies.set.y >> 16u);
    uvec4 high = uvec4(from & 255u, from >> 8u, to & 255u, to >> 8u);
    return bodies.set == uvec2(0u, 0u) ? vec4(0.0) : vec4(low | (high << 16u));
}

TileBodies tile_bodies_of(vec4 texel) {
    uvec4 bits = uvec4(texel);
    uvec4 low = bits & 65535u;
    uvec4 high = bits >> 16u;
    uvec2 way = uvec2(high.x | (high.y << 8u), high.z | (high.w << 8u)) << 16u;
    return TileBodies(uvec2(low.x | (low.y << 16u), low.z | (low.w << 16u)), uintBitsToFloat(way.x), uintBitsToFloat(way.y));
}
