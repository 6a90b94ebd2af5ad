// Which bodies may a tile of the picture show? (object/tile.glsl) Rays take the middle's steps by Mino's time.
#include "core/tile_bodies.glsl"
#include "mino/march.glsl"
#include "mino/ray.glsl"
#include "mino/step.glsl"
#include "object/tile.glsl"
#include "shared/frame.glsl"

#define TILE_NEAR 1.5      // steps that stay beyond as many times the radius of all bodies are left out
#define TILE_BESIDE 0.5    // of a step: as far before its start and behind its end corners' rays are followed
#define TILE_NARROW 0.93   // cosine of the corners from the middle: wider ones' rays are no bundle
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

// The middle ray and the corners'.
struct TileBundle {
    SpinRay rays[TILE_RAYS];
    SpinState now[TILE_RAYS];
    SpinSegment segments[TILE_RAYS];   // the last step's
    float behind[TILE_RAYS];           // the middle ray, by Mino's time: at places next to its
    float pixel_angle;
    bool narrow;
    bool captured;                     // all of them, and those between: a shadow is convex
};

TileBundle tile_bundle(vec2 middle) {
    TileBundle tile;
    tile.narrow = true;
    tile.captured = true;
    vec3 ahead = vec3(0.0);
    for (int k = 0; k < TILE_RAYS; ++k) {
        SpinView view = spin_view(middle + tile_ray(k));
        tile.rays[k] = spin_ray(view);
        tile.now[k] = spin_start(tile.rays[k], view.direction);
        tile.behind[k] = 0.0;
        tile.captured = tile.captured && spin_captured(tile.rays[k], tile.now[k]);
        ahead = k == 0 ? view.direction : ahead;
        tile.narrow = tile.narrow && dot(view.direction, ahead) > TILE_NARROW;
        tile.pixel_angle = k == 0 ? view.pixel_angle : tile.pixel_angle;
    }
    return tile;
}

// Returns the step, by Mino's time: the middle ray's.
float tile_step(inout TileBundle tile, int left) {
    float step = spin_step_length(tile.rays[0], tile.now[0], left);
    for (int k = 0; k < TILE_RAYS; ++k) {
        SpinState from = tile.now[k];
        tile.now[k] = spin_step(tile.rays[k], from, step);
        tile.segments[k] = spin_segment(tile.rays[k], from, tile.now[k], step);
    }
    return step;
}

// among: the only ones that it may show, and where.
TileBodies tile_bodies(vec2 middle, TileBodies among) {
#ifdef MARCH_LISTS
    bodies_near = among.set;
#endif
    TileBundle tile = tile_bundle(middle);
    RayPlace place = segment_place(tile.rays[0], spin_segment(tile.rays[0], tile.now[0], tile.now[0], 1.0), 0.0);
    vec3 start = place.at;
    float end = 1.0 / tile.rays[0].outer;
    int left = SPIN_MOST_STEPS;
    int looks = TILE_LOOKS;
    uvec2 bodies = uvec2(0u, 0u);
    bool bundle = tile.narrow;
    bool below = false;   // all bodies, for good
    bool more = among.set != uvec2(0u, 0u);
    do {
        SpinState before = tile.now[0];
        float step = tile_step(tile, left);
        --left;
        bool far = max(before.y.w, tile.now[0].y.w) * TILE_NEAR * frame.march.x < 1.0 && before.v.w * tile.now[0].v.w > 0.0;
        float s = far ? 1.0 : 0.0;
        while (s < 1.0 && bundle && more && looks > 0) {
            place = segment_place(tile.rays[0], tile.segments[0], s);
            bool outward = dot(place.velocity, place.outward) > 0.0;
            float farther = 0.0;
            TileSpread corners = tile_together();
            for (int k = 1; k < TILE_RAYS; ++k) {
                float there = clamp(s + tile.behind[k] / step, -TILE_BESIDE, 1.0 + TILE_BESIDE);
                RayPlace other = segment_place(tile.rays[k], tile.segments[k], there);
                vec3 off = other.at - place.at;
                corners = tile_spread(corners, place, off);
                tile.behind[k] = (there - s - tile_ahead(place, off) / max(place_speed(place), 1.0e-20)) * step;
                farther = max(farther, abs(other.r - place.r));
            }
            TileLook look = tile_look(place, corners, distance(place.at, start), tile.pixel_angle, bodies);
            bundle = bundle && look.bundle;
            bodies = look.bodies;
            bool away = place.r - look.spread > frame.march.x && tile.now[0].v.w < 0.0;   // from all bodies, for good
            below = tile.captured && place.r + TILE_DEEPER * farther < frame.march_shell.y;
            more = more && look.free < TILE_NONE && !(outward ? away : below);
            s += max(place_part(place, min(TILE_STEP * look.free, 0.4 * place.r)), 1.0e-3);
            --looks;
        }
        more = more && spin_goes(tile.now[0].y.w, end, left, true);
    } while (bundle && more && looks > 0);
    bool ends = below || tile.now[0].y.w < end;   // not at the horizon while others turn
    return tile_whole_way(bundle && ends && looks > 0 && left > 0 ? bodies & among.set : among.set);
}
