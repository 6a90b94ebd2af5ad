// One image of one star in the picture.
struct StarPoint {
    vec2 pixel;    // picture_place() of it
    bool seen;     // not behind the camera
    vec3 peak;     // light in the pixel that it is in the middle of
};
