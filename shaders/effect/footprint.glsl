// Filtering by the ray's own footprint.

// log2 of the square root of a footprint's area, texels, to 0.022 by the bits of a float: half of what lies between powers of two is taken as a
// straight line. Software rasterisers have a polynomial for log2, which costs as much as half a fetch.
float footprint_detail(float area) { return float(floatBitsToInt(area)) * (0.5 / 8388608.0) - 63.4785; }

// The mip level for a level of detail: two levels are mixed only over two fifths of the way between them, so that most pixels
// read one level (on software rasterisers the second costs as much as the first), and no step is seen.
float footprint_level(float detail, float highest) {
    float level = clamp(detail, 0.0, highest);
    float whole = floor(level);
    return whole + clamp(2.5 * (level - whole) - 0.75, 0.0, 1.0);
}
