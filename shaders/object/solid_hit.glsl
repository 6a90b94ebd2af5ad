// What a solid body's hit is known by.
#include "path/place"

struct SolidHit {
    int object;      // its number (scene/ray.h), 0 for none
    float phi;       // swept angle there, about a rotating hole Mino's time; how far the ray goes at least for none
    float covered;   // part of the pixel that the body covers
    RayPlace place;
};

// With a contact more: what the ray enters first, or else comes closest to. What it enters behind that covers what the first leaves, so that
// the ray does not go on to the sky behind an edge, or behind something thinner than a pixel. entered: one before.
SolidHit hit_with_contact(SolidHit hit, bool entered, float along, RayPlace place, float cover, bool enters) {
    if (!entered && (enters || cover > hit.covered)) {
        hit.phi = along;
        hit.place = place;
        hit.covered = cover;
    } else if (enters) {
        hit.covered = cover >= 1.0 ? 1.0 : hit.covered + (1.0 - hit.covered) * cover;
    }
    return hit;
}
