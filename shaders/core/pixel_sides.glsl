// How a place or a direction moves with the pixel: the two sides of the pixel's box there.
struct PixelSides {
    vec3 along;
    vec3 across;
};
