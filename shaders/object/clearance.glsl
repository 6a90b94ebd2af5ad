// How far a place is from a solid that a formula gives, by a grid of cells about it (table/surface_clearance.h).
#define CLEARANCE_CELLS 64     // a side of the cube [-bound, bound]^3
#define CLEARANCE_WIDTH 1024   // of the texture

uniform highp sampler2D clearance_texture;

// r_s, at least; 0 where it is not known. first: the solid's first cell, -1: it has none. The nearest cell that is not empty lies `cells` on
// along an axis: the cells between and the way to the rim of the place's own cell are empty.
float clearance(vec3 at, float bound, float first) {
    vec3 x = (at / bound + 1.0) * (0.5 * float(CLEARANCE_CELLS));
    ivec3 cell = ivec3(clamp(x, 0.0, float(CLEARANCE_CELLS) - 0.5));
    int n = max(int(first), 0) + (cell.z * CLEARANCE_CELLS + cell.y) * CLEARANCE_CELLS + cell.x;
    float cells = texelFetch(clearance_texture, ivec2(n % CLEARANCE_WIDTH, n / CLEARANCE_WIDTH), 0).x;
    vec3 low = x - vec3(cell);
    vec3 rim = min(low, 1.0 - low);
    float way = cells - 1.0 + max(min(min(rim.x, rim.y), rim.z), 0.0);
    return first < 0.0 || cells < 1.0 ? 0.0 : way * (2.0 * bound / float(CLEARANCE_CELLS));
}
