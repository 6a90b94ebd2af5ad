// Does a lattice tell the light of a whole part of the picture? Such parts are drawn by programs that follow no ray: software drivers run both sides
// of a branch.
#include "stage/lattice.glsl"

// From low to high, px from the picture's lower left corner.
bool lattice_tells(vec2 low, vec2 high) {
    float side = float(max(lattice_side, 1));
    ivec2 cells = textureSize(cell_texture, 0);
    ivec2 first = ivec2(floor(low / side)) + 1;
    ivec2 last = ivec2(ceil(high / side));
    bool tells = lattice_side > 0 && min(first.x, first.y) >= 1 && last.x <= cells.x - 3 && last.y <= cells.y - 3;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) tells = tells && texelFetch(cell_texture, clamp(ivec2(x, y), ivec2(0), cells - 1), 0).r > LATTICE_RAYS;
    return tells;
}

#ifdef LATTICE_TOLD
bool lattice_draws(vec2 low, vec2 high) { return lattice_tells(low, high); }
#else
bool lattice_draws(vec2 low, vec2 high) { return !lattice_tells(low, high); }
#endif
