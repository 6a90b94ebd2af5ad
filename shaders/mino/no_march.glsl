// Of mino/march.glsl what a walk asks for (mino/walk.glsl), where there are no bodies.
#include "mino/step.glsl"

struct SolidSearch {
    bool meets;
};

SolidSearch solid_search(bool ours, float pixel_angle) {
    SolidSearch search;
    search.meets = false;
    return search;
}

SolidSearch search_passes(SolidSearch search, SpinState from, SpinState to, float h) {
    search.meets = false;
    return search;
}
