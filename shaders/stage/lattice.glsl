// Light of matter on a lattice of the picture, and between its nodes (render/light_lattice.h). A texel for each node or, in turn, for a node and
// for a place in the cell to its right and above; tiles of them may lie apart, for software drivers draw a block of 64 x 64 texels by one thread. rgb: light; a: what of the light behind comes through, of a ray to the sky; of others -1 less that.
#include "generated/tiles"

uniform highp sampler2D lattice_texture;
uniform highp sampler2D cell_texture;   // a texel a cell (stage/lattice_cells.frag): how the lattice tells the light there
uniform int lattice_side;               // px between its nodes; 0: there is none
uniform int lattice_texels;             // for each node: 1 or 2
uniform int lattice_spread;             // from a tile to the next, in tiles

#define LATTICE_CUBIC 1.0    // by the four by four nodes about the cell
#define LATTICE_LINEAR 0.5   // by its own: next to the shadow's edge
#define LATTICE_RAYS 0.0     // not at all

struct LatticeLight {
    bool known;
    bool escapes;
    vec3 light;
    float through;
};

vec4 lattice_texel(vec3 light, float through, bool escapes) { return vec4(light, escapes ? through : -1.0 - through); }

int lattice_column(int texel) { return texel + texel / TILE_SIDE * TILE_SIDE * (lattice_spread - 1); }

// A node, by its number from the first one, and the place in its cell.
vec4 lattice_node(ivec2 node) { return texelFetch(lattice_texture, ivec2(lattice_column(lattice_texels * node.x), node.y), 0); }
vec4 lattice_probe(ivec2 cell) { return texelFetch(lattice_texture, ivec2(lattice_column(2 * cell.x + 1), cell.y), 0); }

// Where in the cell that is, 0 ... 1: about its middle, where interpolation is worst, but nowhere in step with the nodes, so that no wave of the
// light is the same at all of them.
vec2 probe_part(vec2 cell) {
    vec2 turned = vec2(dot(cell, vec2(0.754877666, 0.569840291)), dot(cell, vec2(0.438579021, 0.618033989)));
    return 0.3 + 0.4 * fract(turned);
}

// Of four values at -1, 0, 1 and 2: the cubic through them, or the line through the middle ones.
vec4 lattice_weights(float t, bool cubic) {
    float a = t + 1.0;
    float b = t - 1.0;
    float c = t - 2.0;
    return cubic ? vec4(-t * b * c, 3.0 * a * b * c, -3.0 * a * t * c, a * t * b) * (1.0 / 6.0) : vec4(0.0, -b, t, 0.0);
}

vec4 lattice_row(ivec2 node, vec4 right) {
    return right.x * lattice_node(node) + right.y * lattice_node(node + ivec2(1, 0)) + right.z * lattice_node(node + ivec2(2, 0)) + right.w * lattice_node(node + ivec2(3, 0));
}

// In the cell whose lower left node is the second of four by four.
vec4 lattice_between(ivec2 first, vec2 part, bool cubic) {
    vec4 right = lattice_weights(part.x, cubic);
    vec4 up = lattice_weights(part.y, cubic);
    return up.x * lattice_row(first, right) + up.y * lattice_row(first + ivec2(0, 1), right) +
           up.z * lattice_row(first + ivec2(0, 2), right) + up.w * lattice_row(first + ivec2(0, 3), right);
}

// At a place in the picture, px from its lower left corner. Cost: 17 fetches.
LatticeLight lattice_light(vec2 place) {
    vec2 at = place / float(max(lattice_side, 1)) + 1.0;   // by nodes' numbers: the first lies before the picture
    vec2 cell = floor(at);
    ivec2 first = clamp(ivec2(cell) - 1, ivec2(0), textureSize(cell_texture, 0) - 4);
    LatticeLight found;
    float told = texelFetch(cell_texture, first + 1, 0).r;
    found.known = lattice_side > 0 && first == ivec2(cell) - 1 && told > LATTICE_RAYS;
    vec4 here = lattice_between(first, at - cell, told > LATTICE_LINEAR);
    found.escapes = here.a > -0.5;
    found.light = max(here.rgb, vec3(0.0));
    found.through = clamp(found.escapes ? here.a : -1.0 - here.a, 0.0, 1.0);
    return found;
}
