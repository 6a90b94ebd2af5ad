// Which bodies may a tile of the picture show? (object/tile.glsl) Rays are compared at places next to each other.
#include "core/tile_bodies.glsl"
#include "object/tile.glsl"
#include "planar/march.glsl"
#include "planar/place.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#define TILE_BEHIND 1.5   // as TILE_SPREAD: how much farther than a corner's a ray of the tile may be ahead or behind
#define TILE_MET 0.1      // of the radius: steps while a body may be met

// Not on the way out beyond every body, nor on the way into the hole below them.
bool tile_goes(bool escapes, RayPlace place, float spread) {
#ifdef TILES_HAVE_SPHERE
    bool below = false;   // it may be below all others
#else
    bool below = !escapes && place.r + spread < frame.march_shell.y;
#endif
    return place.r_along < 0.0 ? !below : place.r - spread < frame.march.x;
}

// among: the only ones that it may show, and where.
TileBodies tile_bodies(vec2 middle, TileBodies among) {
#ifdef MARCH_LISTS
    bodies_near = among.set;
#endif
    Trace rays[TILE_RAYS];     // the middle one, and the corners'
    float behind[TILE_RAYS];   // the middle ray, by swept angle: at places next to its
    bool bundle = true;        // they keep together
    for (int k = 0; k < TILE_RAYS; ++k) {
        rays[k] = trace_pixel(middle + tile_ray(k));
        behind[k] = 0.0;
        bundle = bundle && rays[k].escapes == rays[0].escapes;
    }
    Trace ray = rays[0];
    bundle = bundle && ray.s > 3.0 * tile_longest() * ray.pixel_angle;   // not about the radial direction, where swept angles say nothing
    vec3 tangent = place_tangent(ray);
    vec3 start = radial_direction() / frame.shift.y;
    TileBodies shown = TileBodies(uvec2(0u, 0u), TILE_WAY_END, 0.0);
    float phi = min(among.first, ray.phi_end);
    int left = TILE_LOOKS;
    bool more = among.set != uvec2(0u, 0u);
    bool met = false;   // a body, on the step to this place
    do {
        RayPlace place = place_seen(ray, tangent, phi);
        TileSpread corners = tile_together();
        float ahead = 0.0;
        float back = 0.0;
        for (int k = 1; k < TILE_RAYS; ++k) {
            float there = clamp(phi + behind[k], 0.0, rays[k].phi_end);
            RayPlace other = place_of(rays[k], place_tangent(rays[k]), there);
            vec3 off = other.at - place.at;
            corners = tile_spread(corners, place, off);
            behind[k] = there - phi - tile_ahead(place, off) / max(place_speed(place), 1.0e-20);
            ahead = max(ahead, TILE_BEHIND * behind[k]);
            back = min(back, TILE_BEHIND * behind[k]);
        }
        TileLook look = tile_look(place, corners, distance(place.at, start), ray.pixel_angle, shown.set);
        bundle = bundle && look.bundle;
        shown.set = look.bodies;
        float length = min(TILE_STEP * look.free, 0.4 * place.r);
        if (met) shown.last = max(shown.last, phi + ahead);
        met = TILE_STEP * look.nearest < length;
        if (met) shown.first = min(shown.first, phi + back);
        if (met) length = min(length, max(TILE_MET * place.r, look.spread));
#ifdef MARCH_LISTS
        more = more && phi + back <= among.last;
#else
        more = more && look.free < TILE_NONE;   // there are no others
#endif
        more = more && phi < ray.phi_end && tile_goes(ray.escapes, place, look.spread);
        phi = min(phi + place_part(place, length), ray.phi_end);
        --left;
    } while (bundle && more && left > 0);
    shown.first = max(shown.first, 0.0);
    if (met) shown.last = TILE_WAY_END;
    shown.set = shown.set & among.set;
    if (!bundle || left == 0) shown = among;
    return shown;
}
