// A ray of those through the corners and the middles of the picture's tiles, by its texel (stage/tile_rays.glsl).
#include "core/view.glsl"
#include "generated/tiles"
#ifdef EFFECT_DISC
#include "path/crossings"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/tile_rays.glsl"

struct CornerRay {
    vec4 ray;
    vec4 places;   // where it crosses the disc's plane first and second
#ifdef CROSSINGS_TOLD
    vec4 moves;    // of the light from there: delay and d zeta/d tau, first and second
#endif
};

CornerRay corner_ray(ivec2 texel) {
    float middle = 0.5 * float(texel.x % RAYS_A_TILE);
    vec2 tile = vec2(float(texel.x / RAYS_A_TILE), float(texel.y)) - 1.0;
    Trace trace = trace_pixel(picture_place((tile + middle) * float(TILE_SIDE)));
    CornerRay found;
    found.ray = vec4(trace.sky, trace.escapes ? RAY_ESCAPES : RAY_CAPTURED);
    found.places = vec4(0.0);
#ifdef EFFECT_DISC
    if (!crossings_known(trace)) found.ray.w = RAY_TANGLED;
    found.places = vec4(crossing_place(trace, 0), crossing_place(trace, 1));
#ifdef CROSSINGS_TOLD
    found.moves = vec4(crossing_moves(trace, 0), crossing_moves(trace, 1));
#endif
#endif
    return found;
}
