// May a tile of the picture show a body? (object/tile.glsl) Rays take the middle's steps by Mino's time.
#include "mino/march.glsl"
#include "mino/ray.glsl"
#include "mino/step.glsl"
#include "object/tile.glsl"
#include "shared/frame.glsl"

#define TILE_NEAR 1.5   // steps that stay beyond as many times the radius of all bodies are left out

bool tile_shows_body(vec2 middle) {
    SpinRay rays[TILE_RAYS];
    SpinState now[TILE_RAYS];
    float pixel_angle = 0.0;
    for (int k = 0; k < TILE_RAYS; ++k) {
        SpinView view = spin_view(middle + tile_ray(k));
        rays[k] = spin_ray(view.direction);
        now[k] = spin_start(rays[k], view.direction);
        pixel_angle = k == 0 ? view.pixel_angle : pixel_angle;
    }
    RayPlace place = segment_place(rays[0], spin_segment(rays[0], now[0], now[0], 1.0), 0.0);
    vec3 start = place.at;
    float end = 1.0 / rays[0].outer;
    float step = 0.0;
    float s = 1.0;
    int left = SPIN_MOST_STEPS;
    int looks = TILE_LOOKS;
    bool clear = true;
    bool more = true;
    SpinSegment segments[TILE_RAYS];
    do {
        if (s >= 1.0) {
            SpinState before = now[0];
            step = spin_step_length(rays[0], before, left);
            for (int k = 0; k < TILE_RAYS; ++k) {
                SpinState from = now[k];
                now[k] = spin_step(rays[k], from, step);
                segments[k] = spin_segment(rays[k], from, now[k], step);
            }
            --left;
            bool far = max(before.y.w, now[0].y.w) * TILE_NEAR * frame.march.x < 1.0 && before.v.w * now[0].v.w > 0.0;
            s = far ? 1.0 : 0.0;
        }
        if (s < 1.0) {
            place = segment_place(rays[0], segments[0], s);
            vec2 offset = vec2(0.0, 0.0);
            for (int k = 1; k < TILE_RAYS; ++k) offset = max(offset, tile_offset(place, segment_place(rays[k], segments[k], s).at));
            vec3 chord = place.at - start;
            TileLook look = tile_look(place, offset.x, offset.y, sqrt(dot(chord, chord)), pixel_angle);
            clear = clear && look.clear;
            bool outward = dot(place.velocity, place.outward) > 0.0;
            bool away = place.r - look.spread > frame.march.x && now[0].v.w < 0.0;   // from all bodies, for good
            more = outward ? !away : place.r + look.spread > frame.march_shell.z;
            s += max(march_part(place, min(TILE_STEP * look.free, 0.4 * place.r)), 1.0e-3);
            --looks;
        }
        more = more && (s < 1.0 || spin_goes(now[0].y.w, end, left, true));
    } while (clear && more && looks > 0);
    return !clear || looks == 0 || left == 0;
}
