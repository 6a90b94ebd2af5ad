// Filtering by the ray's own footprint.

// The mip level for a level of detail: two levels are mixed only over two fifths of the way between them, so that most pixels
// read one level (on software rasterisers the second costs as much as the first), and no step is seen.
float footprint_level(float detail, float highest) {
    float level = clamp(detail, 0.0, highest);
    float whole = floor(level);
    return whole + clamp(2.5 * (level - whole) - 0.75, 0.0, 1.0);
}
