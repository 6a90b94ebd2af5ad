// A lattice of the light of matter: rays are followed where the next coarser lattice does not tell it (stage/lattice.glsl).
#include "core/view.glsl"
#ifndef LATTICE_TOLD
#include "path/medium"
#include "path/trace"
#endif
#include "stage/lattice.glsl"

uniform int lattice_drawn;   // px between the nodes of this one
uniform int lattice_drawn_texels;
uniform int lattice_drawn_spread;

out vec4 colour;

#ifndef LATTICE_TOLD
vec4 lattice_traced(vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    MediumWalk walk = medium_to(trace, medium_walk(trace, pixel), 1.0e30);
    return lattice_texel(medium_seen_light(walk.sum), medium_left(walk.sum), trace.escapes);
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    texel.x = texel.x / (TILE_SIDE * lattice_drawn_spread) * TILE_SIDE + texel.x % TILE_SIDE;
    vec2 node = vec2(float(texel.x / lattice_drawn_texels), float(texel.y));
    vec2 place = float(lattice_drawn) * (node - 1.0 + float(texel.x % lattice_drawn_texels) * probe_part(node));
    LatticeLight found = lattice_light(place);
    colour = lattice_texel(found.light, found.through, found.escapes);
#ifndef LATTICE_TOLD
    if (!found.known) colour = lattice_traced(picture_place(place));
#endif
}
