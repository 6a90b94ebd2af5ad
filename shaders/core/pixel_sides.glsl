// How a place or a direction moves with the pixel: the two sides of the pixel's box there.
struct PixelSides {
    vec3 along;
    vec3 across;
};

// Of a pixel's box on the sky, over the angle that the pixel spans: the longer side, and the area over it.
vec2 sides_stretch(PixelSides sides, float pixel_angle) {
    float longer = max(sqrt(max(dot(sides.along, sides.along), dot(sides.across, sides.across))), 1.0e-20);
    vec3 area = cross(sides.along, sides.across);
    return vec2(longer / pixel_angle, sqrt(dot(area, area)) / (longer * pixel_angle));
}
