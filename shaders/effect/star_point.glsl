// One image of one star in the picture.
struct StarPoint {
    vec2 pixel;    // px from the picture's middle, y up
    float ahead;   // above 0 before the camera
    vec3 peak;     // light in the pixel that it is in the middle of
};
