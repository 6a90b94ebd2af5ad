// The light of a lattice's texel: by its ray where the next coarser lattice does not tell it (stage/lattice.glsl).
#include "core/view.glsl"
#ifndef LATTICE_TOLD
#include "path/medium"
#include "path/trace"
#endif
#include "stage/lattice.glsl"

uniform int lattice_drawn;   // px between the nodes of this one
uniform int lattice_drawn_texels;
uniform int lattice_drawn_spread;

#ifndef LATTICE_TOLD
vec4 lattice_traced(vec2 pixel) {
    Trace trace = trace_pixel(pixel);
    MediumWalk walk = medium_to(trace, medium_walk(trace, pixel), 1.0e30);
    return lattice_texel(medium_seen_light(walk.sum), medium_left(walk.sum), trace.escapes);
}
#endif

// texel: by its number, as if tiles lay side by side.
vec4 lattice_light_of(ivec2 texel) {
    vec2 node = vec2(float(texel.x / lattice_drawn_texels), float(texel.y));
    vec2 place = float(lattice_drawn) * (node - 1.0 + float(texel.x % lattice_drawn_texels) * probe_part(node));
    LatticeLight found = lattice_light(place);
    vec4 light = lattice_texel(found.light, found.through, found.escapes);
#ifndef LATTICE_TOLD
    if (!found.known) light = lattice_traced(picture_place(place));
#endif
    return light;
}
