// May a tile of the picture show a body? (object/tile.glsl) Rays are compared at equal swept angles.
#include "object/tile.glsl"
#include "planar/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

bool tile_shows_body(vec2 middle) {
    Trace rays[TILE_RAYS];
    bool clear = true;   // unless the tile is about the radial direction, where swept angles say nothing
    for (int k = 0; k < TILE_RAYS; ++k) {
        rays[k] = trace_pixel(middle + tile_ray(k));
        clear = clear && rays[k].escapes == rays[0].escapes;
    }
    Trace ray = rays[0];
    clear = clear && ray.s > 3.0 * TILE_REACH * ray.pixel_angle;
    vec3 tangent = place_tangent(ray);
    vec3 start = radial_direction() / frame.shift.y;
    float phi = 0.0;
    int left = TILE_LOOKS;
    bool more = true;
    do {
        RayPlace place = place_seen(ray, tangent, phi);
        vec2 offset = vec2(0.0, 0.0);
        for (int k = 1; k < TILE_RAYS; ++k)
            offset = max(offset, tile_offset(place, place_of(rays[k], place_tangent(rays[k]), min(phi, rays[k].phi_end)).at));
        vec3 chord = place.at - start;
        TileLook look = tile_look(place, offset.x, offset.y, sqrt(dot(chord, chord)), ray.pixel_angle);
        clear = clear && look.clear;
        // Not on the way out beyond every body, nor on the way into the hole below them.
#ifdef TILES_HAVE_SPHERE
        bool below = false;   // it may be below all others
#else
        bool below = !ray.escapes && place.r + look.spread < frame.march_shell.y;
#endif
        more = phi < ray.phi_end && (place.r_along < 0.0 ? !below : place.r - look.spread < frame.march.x);
        phi = min(phi + march_angle(place, min(TILE_STEP * look.free, 0.4 * place.r)), ray.phi_end);
        --left;
    } while (clear && more && left > 0);
    return !clear || left == 0;
}
