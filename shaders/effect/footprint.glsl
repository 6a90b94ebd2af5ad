// Filtering by the ray's own footprint: a parallelogram with sides a and b on the texture. Taps along the longer side, the mip
// level of the shorter one: neither blur nor shimmer. Most pixels need one tap; the most is a uniform, so cost is bounded.

struct Taps {
    int count;
    float level;
};

// long_side, short_side in texels.
Taps footprint_taps(float long_side, float short_side, float most, float highest_level) {
    float narrow = max(max(short_side, long_side / most), 1.0e-6);
    Taps taps;
    taps.count = int(clamp(ceil(long_side / narrow - 0.5), 1.0, most));
    if (long_side <= 1.0) taps.count = 1;
    taps.level = clamp(log2(long_side / float(taps.count)), 0.0, highest_level);
    return taps;
}
