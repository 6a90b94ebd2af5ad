// Which bodies may a tile of the picture show? (object/tile.glsl) Rays take the middle's steps by Mino's time.
#include "mino/march.glsl"
#include "mino/ray.glsl"
#include "mino/step.glsl"
#include "object/tile.glsl"
#include "shared/frame.glsl"

#define TILE_NEAR 1.5      // steps that stay beyond as many times the radius of all bodies are left out
#define TILE_BESIDE 0.5    // of a step: as far before its start and behind its end corners' rays are followed
#define TILE_DEEPER 1.5    // how much more than the corners' rays those between may differ in radius

#define CAPTURED_LOOKS 12
#define CAPTURED_CLEARLY 0.1   // zeta'^2 over X^2: no root lies between two looks

// Does a ray that comes inward reach the horizon?
bool spin_captured(SpinRay ray, SpinState from) {
    bool captured = from.v.w > 0.0;
    for (int i = 1; i <= CAPTURED_LOOKS; ++i) {
        float zeta = mix(from.y.w, 1.0 / ray.outer, float(i) / float(CAPTURED_LOOKS));
        float x = spin_x(ray, zeta, 0.0);
        captured = captured && spin_delta(ray, zeta, 0.0) * zeta * zeta * ray.k < (1.0 - CAPTURED_CLEARLY) * x * x;
    }
    return captured;
}

// among: the only ones that it may show.
uvec2 tile_bodies(vec2 middle, uvec2 among) {
#ifdef MARCH_LISTS
    bodies_near = among;
#endif
    SpinRay rays[TILE_RAYS];
    SpinState now[TILE_RAYS];
    float behind[TILE_RAYS];   // the middle ray, by Mino's time: at places next to its
    float pixel_angle = 0.0;
    bool captured = true;   // all of them, and those between: a shadow is convex
    for (int k = 0; k < TILE_RAYS; ++k) {
        SpinView view = spin_view(middle + tile_ray(k));
        rays[k] = spin_ray(view);
        now[k] = spin_start(rays[k], view.direction);
        behind[k] = 0.0;
        captured = captured && spin_captured(rays[k], now[k]);
        pixel_angle = k == 0 ? view.pixel_angle : pixel_angle;
    }
    RayPlace place = segment_place(rays[0], spin_segment(rays[0], now[0], now[0], 1.0), 0.0);
    vec3 start = place.at;
    float end = 1.0 / rays[0].outer;
    int left = SPIN_MOST_STEPS;
    int looks = TILE_LOOKS;
    uvec2 bodies = uvec2(0u, 0u);
    bool bundle = true;
    bool below = false;   // all bodies, for good
    bool more = among != uvec2(0u, 0u);
    SpinSegment segments[TILE_RAYS];
    do {
        SpinState before = now[0];
        float step = spin_step_length(rays[0], before, left);
        for (int k = 0; k < TILE_RAYS; ++k) {
            SpinState from = now[k];
            now[k] = spin_step(rays[k], from, step);
            segments[k] = spin_segment(rays[k], from, now[k], step);
        }
        --left;
        bool far = max(before.y.w, now[0].y.w) * TILE_NEAR * frame.march.x < 1.0 && before.v.w * now[0].v.w > 0.0;
        float s = far ? 1.0 : 0.0;
        while (s < 1.0 && bundle && more && looks > 0) {
            place = segment_place(rays[0], segments[0], s);
            bool outward = dot(place.velocity, place.outward) > 0.0;
            float farther = 0.0;
            TileSpread corners = tile_together();
            for (int k = 1; k < TILE_RAYS; ++k) {
                float there = clamp(s + behind[k] / step, -TILE_BESIDE, 1.0 + TILE_BESIDE);
                RayPlace other = segment_place(rays[k], segments[k], there);
                vec3 off = other.at - place.at;
                corners = tile_spread(corners, place, off);
                behind[k] = (there - s - tile_ahead(place, off) / max(place_speed(place), 1.0e-20)) * step;
                farther = max(farther, abs(other.r - place.r));
            }
            TileLook look = tile_look(place, corners, distance(place.at, start), pixel_angle, bodies);
            bundle = bundle && look.bundle;
            bodies = look.bodies;
            bool away = place.r - look.spread > frame.march.x && now[0].v.w < 0.0;   // from all bodies, for good
            below = captured && place.r + TILE_DEEPER * farther < frame.march_shell.y;
            more = more && look.free < TILE_NONE && !(outward ? away : below);
            s += max(place_part(place, min(TILE_STEP * look.free, 0.4 * place.r)), 1.0e-3);
            --looks;
        }
        more = more && spin_goes(now[0].y.w, end, left, true);
    } while (bundle && more && looks > 0);
    bool ends = below || now[0].y.w < end;   // not at the horizon while others turn
    return bundle && ends && looks > 0 && left > 0 ? bodies & among : among;
}
