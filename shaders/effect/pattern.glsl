// Patterns of two colours, averaged over a pixel's box: 1 the first colour, 0 the second. p: in cells; wide: the box's sides.

// Integral of the square wave that is +1 on [0, 1), -1 on [1, 2), and so on.
float pattern_wave(float t) { return 1.0 - abs(t - 2.0 * floor(0.5 * t) - 1.0); }

float pattern_mean_wave(float t, float wide) {
    float w = max(wide, 1.0e-5);
    return clamp((pattern_wave(t + 0.5 * w) - pattern_wave(t - 0.5 * w)) / w, -1.0, 1.0);
}

float pattern_checker(vec2 p, vec2 wide) { return 0.5 + 0.5 * pattern_mean_wave(p.x, wide.x) * pattern_mean_wave(p.y, wide.y); }

float pattern_stripes(vec2 p, vec2 wide) { return 0.5 + 0.5 * pattern_mean_wave(p.y, wide.y); }

// Lines of PATTERN_LINE of a cell about whole numbers.
#define PATTERN_LINE 0.08
float pattern_line(float t, float wide) {
    float w = max(wide, 1.0e-5);
    float a = t + 0.5 * PATTERN_LINE - 0.5 * w;
    float b = a + w;
    float lines = (floor(b) - floor(a)) * PATTERN_LINE + min(b - floor(b), PATTERN_LINE) - min(a - floor(a), PATTERN_LINE);
    return clamp(lines / w, 0.0, 1.0);
}

float pattern_grid(vec2 p, vec2 wide) { return 1.0 - (1.0 - pattern_line(p.x, wide.x)) * (1.0 - pattern_line(p.y, wide.y)); }
