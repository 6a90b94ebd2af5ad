// What a solid body's hit is known by.
#include "path/place"

struct SolidHit {
    int object;      // its number (scene/ray.h), 0 for none
    float phi;       // swept angle there, about a rotating hole Mino's time; how far the ray goes at least for none
    float covered;   // part of the pixel that the body covers
    RayPlace place;
};
