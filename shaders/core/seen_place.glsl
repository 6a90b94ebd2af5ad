// Where in the picture something is seen.
struct ViewPlace {
    vec2 at;         // px of a pixel's height from the line of sight, y up
    bool seen;       // not behind a pinhole
    float pixels;    // solid angle of a pixel there, sr
};
