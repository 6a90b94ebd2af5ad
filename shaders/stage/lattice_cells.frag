// Which cells of a lattice tell the light in them (stage/lattice.glsl): where at a place in them, and in the four cells beside them, what is
// between the nodes is as the light of that place's own ray, and all of these rays end on the sky, or none. Of a lattice of nodes alone: where
// there is little difference between its cubic and its line, or between its own nodes.
#include "effect/edge.glsl"
#include "stage/lattice.glsl"

uniform int lattice_columns;   // of nodes
uniform int lattice_error;      // thousandths of the light, and of the light behind
#define LATTICE_DARKEST 0.05    // of white: errors of less light than this are as for this

out vec4 colour;

bool is_near(vec4 found, vec4 there) {
    float error = 0.001 * float(lattice_error);
    vec3 off = abs(found.rgb - there.rgb);
    float most = max(there.r, max(there.g, there.b)) + LATTICE_DARKEST / edge_exposure();
    return max(off.r, max(off.g, off.b)) < error * most && abs(found.a - there.a) < error;
}

bool tells_probe(ivec2 cell, bool cubic) {
    vec4 found = lattice_between(cell - 1, probe_part(vec2(cell)), cubic);
    if (lattice_texels > 1) return is_near(found, lattice_probe(cell));
    if (cubic) return is_near(found, lattice_between(cell - 1, probe_part(vec2(cell)), false));
    return is_near(found, lattice_node(cell)) && is_near(found, lattice_node(cell + 1));
}

// Rays of the four by four nodes about a cell, or of its own, and of the place in it.
bool ends_alike(ivec2 cell, bool cubic) {
    bool sky = (lattice_texels > 1 ? lattice_probe(cell) : lattice_node(cell)).a >= 0.0;
    bool alike = true;
    for (int k = 0; k < 16; ++k) {
        ivec2 node = ivec2(k % 4, k / 4) - 1;
        bool own = (node & 1) == node;
        alike = alike && (!(cubic || own) || (lattice_node(cell + node).a >= 0.0) == sky);
    }
    return alike;
}

void main() {
    ivec2 low = ivec2(1);   // cells with nodes on all sides
    ivec2 high = ivec2(lattice_columns, textureSize(lattice_texture, 0).y) - 3;
    ivec2 cell = clamp(ivec2(gl_FragCoord.xy), low, high);
    bool cubic = ends_alike(cell, true);
    bool tells = cell == ivec2(gl_FragCoord.xy) && ends_alike(cell, false) && tells_probe(cell, cubic);
    for (int k = 0; k < 4; ++k) {
        int off = 2 * (k % 2) - 1;
        ivec2 beside = clamp(cell + (k < 2 ? ivec2(off, 0) : ivec2(0, off)), low, high);
        tells = tells && (tells_probe(beside, cubic) || (!cubic && !ends_alike(beside, false)));
    }
    colour = vec4(tells ? cubic ? LATTICE_CUBIC : LATTICE_LINEAR : LATTICE_RAYS);
}
