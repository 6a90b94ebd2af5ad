// Which bodies may a tile of the picture show? (object/tile.glsl) Rays are compared at places next to each other.
#include "object/tile.glsl"
#include "planar/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

// among: the only ones that it may show.
uvec2 tile_bodies(vec2 middle, uvec2 among) {
#ifdef MARCH_LISTS
    bodies_near = among;
#endif
    Trace rays[TILE_RAYS];
    float behind[TILE_RAYS];   // the middle ray, by swept angle: at places next to its
    bool bundle = true;   // unless the tile is about the radial direction, where swept angles say nothing
    for (int k = 0; k < TILE_RAYS; ++k) {
        rays[k] = trace_pixel(middle + tile_ray(k));
        behind[k] = 0.0;
        bundle = bundle && rays[k].escapes == rays[0].escapes;
    }
    Trace ray = rays[0];
    bundle = bundle && ray.s > 3.0 * tile_longest() * ray.pixel_angle;
    vec3 tangent = place_tangent(ray);
    vec3 start = radial_direction() / frame.shift.y;
    uvec2 bodies = uvec2(0u, 0u);
    float phi = 0.0;
    int left = TILE_LOOKS;
    bool more = among != uvec2(0u, 0u);
    do {
        RayPlace place = place_seen(ray, tangent, phi);
        TileSpread corners = tile_together();
        for (int k = 1; k < TILE_RAYS; ++k) {
            float there = clamp(phi + behind[k], 0.0, rays[k].phi_end);
            RayPlace other = place_of(rays[k], place_tangent(rays[k]), there);
            vec3 off = other.at - place.at;
            corners = tile_spread(corners, place, off);
            behind[k] = there - phi - tile_ahead(place, off) / max(place_speed(place), 1.0e-20);
        }
        vec3 chord = place.at - start;
        TileLook look = tile_look(place, corners, sqrt(dot(chord, chord)), ray.pixel_angle, bodies);
        bundle = bundle && look.bundle;
        bodies = look.bodies;
        // Not on the way out beyond every body, nor on the way into the hole below them.
#ifdef TILES_HAVE_SPHERE
        bool below = false;   // it may be below all others
#else
        bool below = !ray.escapes && place.r + look.spread < frame.march_shell.y;
#endif
        more = more && phi < ray.phi_end && look.free < TILE_NONE && (place.r_along < 0.0 ? !below : place.r - look.spread < frame.march.x);
        phi = min(phi + place_part(place, min(TILE_STEP * look.free, 0.4 * place.r)), ray.phi_end);
        --left;
    } while (bundle && more && left > 0);
    return bundle && left > 0 ? bodies & among : among;
}
