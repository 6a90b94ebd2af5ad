// Matter of a file (scene/medium_grid.h): eight numbers of each node in two texels, between nodes linear in ln r, theta and phi. Of slow light
// each place is of the time when its light left, linear between two dumps.
#include "core/trig.glsl"
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/sphere.glsl"
#include "path/azimuth"
#include "shared/frame.glsl"

uniform highp sampler2DArray medium_texture;

struct GridNumbers {
    vec4 first;    // log2 of the density; four-velocity along e_r (times sqrt(1 - horizon/r)), e_theta, e_phi
    vec4 second;   // log2 of the temperature; magnetic field along the same, where the matter rests
};

// polar: rows of dumps before it too.
GridNumbers grid_node(float ring, float polar, float around) {
    ivec3 at = ivec3(2 * int(ring), int(polar), int(around));
    return GridNumbers(texelFetch(medium_texture, at, 0), texelFetch(medium_texture, at + ivec3(1, 0, 0), 0));
}

GridNumbers grid_mix(GridNumbers a, GridNumbers b, float part) {
    return GridNumbers(mix(a.first, b.first, part), mix(a.second, b.second, part));
}

// Numbers of nodes from the first one, at a circle of equal r and theta: those of the two azimuths beside it.
GridNumbers grid_around(float ring, float polar, float left, float right, float part) {
    return grid_mix(grid_node(ring, polar, left), grid_node(ring, polar, right), part);
}

// at: number of nodes of ln r and of theta from the first one, within the grid, and turns of phi from it. slot: of the dump in the texture.
GridNumbers grid_at(vec3 at, float slot) {
    float around = (at.z - floor(at.z)) * GRID_AROUND_COUNT;
    vec3 low = floor(vec3(at.x, at.y, around));
    vec3 part = vec3(at.x, at.y, around) - low;
    float ring = min(low.x + 1.0, GRID_RING_COUNT - 1.0);
    float polar = min(low.y + 1.0, GRID_POLAR_COUNT - 1.0) + slot * GRID_POLAR_COUNT;
    low.y += slot * GRID_POLAR_COUNT;
    float left = low.z < GRID_AROUND_COUNT && low.z > 0.0 ? low.z : 0.0;
    float right = left + 1.0 < GRID_AROUND_COUNT ? left + 1.0 : 0.0;
    GridNumbers north = grid_mix(grid_around(low.x, low.y, left, right, part.z), grid_around(ring, low.y, left, right, part.z), part.x);
    GridNumbers south = grid_mix(grid_around(low.x, polar, left, right, part.z), grid_around(ring, polar, left, right, part.z), part.x);
    return grid_mix(north, south, part.y);
}

#ifdef EFFECT_MEDIUM_MOTION
// By how much the dumps' clock, v - r of light that comes in, is ahead of t (src/plan/medium_file.cpp).
float grid_ahead(float r) {
    float beyond = max(r - GRID_INNER, 1.0e-6);
    float outside = max(r - frame.medium_hole.y, 1.0e-6);
    return GRID_AHEAD > 0.0 ? log(beyond) + GRID_AHEAD_LOG * log(outside / beyond) : 0.0;
}

// When the light left: of both dumps about that time.
GridNumbers grid_then(vec3 at, MediumPlace place) {
    float later = grid_ahead(place.r);
#ifdef NEEDS_PLACE_LATE
    later -= place.delay;
#endif
    float dump = clamp(GRID_TIME + later * GRID_RATE, 0.0, GRID_LAST);
    float before = floor(dump);
    float after = min(before + 1.0, GRID_LAST);
    float slot = before + GRID_SLOT;
    float next = after + GRID_SLOT;
    slot = slot < GRID_SLOTS ? slot : slot - GRID_SLOTS;
    next = next < GRID_SLOTS ? next : next - GRID_SLOTS;
    return grid_mix(grid_at(at, slot), grid_at(at, next), dump - before);
}
#else
GridNumbers grid_then(vec3 at, MediumPlace place) { return grid_at(at, 0.0); }
#endif

MediumMatter medium_matter(MediumPlace place) {
    float across = sqrt(place.at.x * place.at.x + place.at.y * place.at.y);
    float theta = arc_tangent2(across, place.at.z);
    float phi = azimuth_plus(bearing(place.at.y, place.at.x), place.turn);
    vec2 along = vec2((log(place.r) - GRID_RING) * GRID_RINGS, (theta - GRID_POLAR) * GRID_POLARS);
    // Far out a place is no number, and nothing that is found there is used.
    float ring = along.x > 0.0 ? min(along.x, GRID_RING_COUNT - 1.0) : 0.0;
    float polar = along.y > 0.0 ? min(along.y, GRID_POLAR_COUNT - 1.0) : 0.0;
    GridNumbers found = grid_then(vec3(ring, polar, phi * 0.15915494309189533577 - GRID_AROUND), place);
    vec3 field = vec3(found.second.y, found.second.z, found.second.w);
    float strength = sqrt(dot(field, field));
    MediumMatter matter = medium_in_sphere(place);
    matter.density = min(exp2(found.first.x) * GRID_DENSITY, DENSEST_MATTER);
    matter.temperature = exp2(found.second.x);
    matter.field = strength * GRID_FIELD;
#ifdef FIELD_DIRECTION
    matter.field_way = FIELD_DIRECTION;
#else
    matter.field_way = field / max(strength, 1.0e-20);
#endif
    float fall = inversesqrt(max(1.0 - GRID_HORIZON / place.r, LEAST_FALL));
    vec3 velocity = vec3(clamp(found.first.y * fall, -FASTEST_MATTER, FASTEST_MATTER), found.first.z, found.first.w);
    return medium_moving(place, medium_heated(matter), velocity);
}
