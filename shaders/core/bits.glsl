// Up to 64 bodies of a scene, a bit each.
bool bit_in(int i, uvec2 set) { return (((i < 32 ? set.x : set.y) >> uint(i & 31)) & 1u) != 0u; }

uvec2 with_bit(int i, uvec2 set) {
    uint bit = 1u << uint(i & 31);
    return i < 32 ? uvec2(set.x | bit, set.y) : uvec2(set.x, set.y | bit);
}

// The first from i on, 64 if there is none.
int bit_from(int i, uvec2 set) {
    uint word = i < 32 ? set.x >> uint(i & 31) : 0u;
    int at = i;
    if (word == 0u) {
        at = max(i, 32);
        word = at < 64 ? set.y >> uint(at & 31) : 0u;
    }
    uint lowest = word & (~word + 1u);
    return word == 0u ? 64 : at + (floatBitsToInt(float(lowest)) >> 23) - 127;
}

uvec2 without_first(uvec2 set) { return set.x != 0u ? uvec2(set.x & (set.x - 1u), set.y) : uvec2(0u, set.y & (set.y - 1u)); }

// As a texel: 16 bits a channel.
vec4 texel_of(uvec2 set) { return vec4(float(set.x & 65535u), float(set.x >> 16u), float(set.y & 65535u), float(set.y >> 16u)); }
uvec2 set_of(vec4 texel) { return uvec2(uint(texel.x) | (uint(texel.y) << 16u), uint(texel.z) | (uint(texel.w) << 16u)); }
