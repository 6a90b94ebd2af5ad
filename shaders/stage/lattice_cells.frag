// Which cells of a lattice tell the light in them (stage/lattice.glsl): where at a place in them, and in the four cells beside them, cubics between
// the nodes are as the light of that place's own ray, and all of these rays end on the sky, or none.
#include "effect/edge.glsl"
#include "stage/lattice.glsl"

#define LATTICE_ERROR 0.005     // of the light
#define LATTICE_DARKEST 0.05    // of white: errors of less light than this are as for this
#define LATTICE_THROUGH 0.005   // of the light behind

out vec4 colour;

bool tells_probe(ivec2 cell) {
    vec4 found = lattice_between(cell - 1, probe_part(vec2(cell)));
    vec4 there = lattice_probe(cell);
    vec3 off = abs(found.rgb - there.rgb);
    float most = max(there.r, max(there.g, there.b)) + LATTICE_DARKEST / edge_exposure();
    return max(off.r, max(off.g, off.b)) < LATTICE_ERROR * most && abs(found.a - there.a) < LATTICE_THROUGH;
}

bool ends_alike(ivec2 cell) {
    bool sky = lattice_probe(cell).a >= 0.0;
    bool alike = true;
    for (int k = 0; k < 16; ++k) alike = alike && (lattice_node(cell + ivec2(k % 4, k / 4) - 1).a >= 0.0) == sky;
    return alike;
}

void main() {
    ivec2 low = ivec2(1);   // cells with nodes on all sides
    ivec2 high = textureSize(lattice_texture, 0) / ivec2(2, 1) - 3;
    ivec2 cell = clamp(ivec2(gl_FragCoord.xy), low, high);
    bool tells = cell == ivec2(gl_FragCoord.xy) && ends_alike(cell) && tells_probe(cell);
    for (int k = 0; k < 4; ++k) {
        int off = 2 * (k % 2) - 1;
        ivec2 beside = cell + (k < 2 ? ivec2(off, 0) : ivec2(0, off));
        tells = tells && tells_probe(clamp(beside, low, high));
    }
    colour = vec4(tells ? 1.0 : 0.0);
}
