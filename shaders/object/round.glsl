// Round bodies narrower than a pixel: their edges are not softened each for itself, but all of the body is.

#define ROUND_WIDE 0.5774   // px: from here on edges are softened half a pixel to both sides; 1/sqrt(3)

// How much of a pixel is covered whose middle is `off` from the body's, both and the radius in pixels. Over all pixels about the body this
// sums to its area, wherever between them it is: within 4 % of what is narrow, within 12 % next to ROUND_WIDE.
float round_cover(float radius, float off) {
    float area = 3.14159265358979 * radius * radius;
    float near = min(off, 1.0);
    float narrow = area * (1.0 - near * (0.5 + near * (1.5 - near)));
    float wide = 0.5 + sqrt(max(radius * radius - 1.0 / 12.0, 0.0)) - off;   // an edge softened to both sides adds 1/12 pi
    return clamp(radius < ROUND_WIDE ? narrow : wide, 0.0, 1.0);
}
