// Up to 64 bodies of a scene, a bit each.
bool bit_in(int i, uvec2 set) {
    uint low = set.x;
    uint high = set.y;
    uint word = i < 32 ? low : high;
    return ((word >> uint(i & 31)) & 1u) != 0u;
}

uvec2 with_bit(int i, uvec2 set) {
    uint bit = 1u << uint(i & 31);
    uvec2 low = uvec2(set.x | bit, set.y);
    uvec2 high = uvec2(set.x, set.y | bit);
    return i < 32 ? low : high;
}

// The first from i on, 64 if there is none.
int bit_from(int i, uvec2 set) {
    uint low = set.x >> uint(i & 31);
    low = i < 32 ? low : 0u;
    int behind = max(i, 32);
    uint high = set.y >> uint(behind & 31);
    high = behind < 64 ? high : 0u;
    uint word = low != 0u ? low : high;
    int at = low != 0u ? i : behind;
    uint lowest = word & (~word + 1u);
    int found = at + (floatBitsToInt(float(lowest)) >> 23) - 127;
    return word == 0u ? 64 : found;
}

uvec2 without_first(uvec2 set) {
    uvec2 low = uvec2(set.x & (set.x - 1u), set.y);
    uvec2 high = uvec2(0u, set.y & (set.y - 1u));
    return set.x != 0u ? low : high;
}
