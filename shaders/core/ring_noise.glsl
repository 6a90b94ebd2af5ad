// Noise in rings. A ring has 8 cells in octave 0 and twice as many in each next one, whose values are a permutation of equal steps from -1
// to 1: their mean and their square's are a ring's own. Between cells and between rings squares of weights add up to 1, so that the noise of
// an octave has the same spread everywhere.

#define RING_CELL_BITS 3

// A ring's number, well mixed.
uint ring_key(int ring, int level) {
    uint h = uint(ring) * 0x85157AF5u ^ (uint(level) * 0xC3D2E1F1u + 0x9E3779B1u);
    h ^= h >> 16u;
    h *= 0x7FEB352Du;
    h ^= h >> 15u;
    h *= 0x6C8E9CF5u;
    return h ^ (h >> 16u);
}

// Of cell number `cell` of a ring with 2^bits: a permutation, by steps that lose no bit.
float ring_cell(int cell, uint key, int bits) {
    uint mask = (1u << uint(bits)) - 1u;
    uint shift = uint((bits + 1) / 2);
    uint h = (uint(cell) ^ key) & mask;
    h = (h * 0x9E3779B1u) & mask;
    h ^= h >> shift;
    h = (h * ((key >> 9u) | 1u) + (key >> 20u)) & mask;
    h ^= h >> shift;
    h = (h * 0x85157AF5u) & mask;
    return (2.0 * float(h) + 1.0) / float(mask + 1u) - 1.0;
}

// Weights of two neighbours.
vec2 ring_weights(float t) {
    float s = t * t * (3.0 - 2.0 * t);
    return vec2(1.0 - s, s) * inversesqrt(s * s + (1.0 - s) * (1.0 - s));
}

// At so many turns from where the ring's first cell begins.
float ring_noise(int ring, int level, float turns) {
    int bits = RING_CELL_BITS + level;
    float at = turns * float(1 << bits);
    float cell = floor(at);
    vec2 weights = ring_weights(at - cell);
    uint key = ring_key(ring, level);
    return weights.x * ring_cell(int(cell), key, bits) + weights.y * ring_cell(int(cell) + 1, key, bits);
}
